// The only file that knows Assimp. Its headers warn where ours do not, so they are system headers to the build.
#include "physim/scenario.hpp"

#include <cstdint>
#include <optional>
#include <utility>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/files_in_use.hpp"
#include "scenario/gltf_nodes.hpp"
#include "scenario/libraries.hpp"
#include "scenario/mesh_text.hpp"
#include "scenario/text_file.hpp"

#if PHYSIM_HAS_ASSIMP
#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#endif

namespace physim {

bool reads_mesh_files() { return PHYSIM_HAS_ASSIMP != 0; }

#if PHYSIM_HAS_ASSIMP

namespace {

constexpr std::uintmax_t kLargestMesh = 256 << 20;  // [bytes]

/// Opens what Assimp reads: the file itself, and files that it names, such as materials and buffers of glTF. Each is a
/// regular file of a bounded size, or is not there for Assimp.
class MeshFiles : public Assimp::DefaultIOSystem {
 public:
  /// `status` becomes that of the first file that may not be read. The mesh's own file has the text `instead`, unless
  /// that is null.
  MeshFiles(Status& status, std::string file, const std::string* instead)
      : status_(status), file_(std::move(file)), instead_(instead) {}

  bool Exists(const char* file) const override { return check_file(file, kLargestMesh, "mesh").ok(); }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (Status begun = begin_reading(file, "mesh"); !begun) {
      if (status_) status_ = begun;
      return nullptr;
    }
    if (instead_ != nullptr && file == file_)
      return new Assimp::MemoryIOStream(static_cast<const std::uint8_t*>(static_cast<const void*>(instead_->data())),
                                        instead_->size());
    return Exists(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
  }

 private:
  Status& status_;
  std::string file_;
  const std::string* instead_;
};

/// Gives corners, which have whole numbers, the places that the file has. False if the file lacks one.
bool put_in_place(MeshShape& mesh, const NumberedMesh& file) {
  for (Vec3d& v : mesh.vertices) {
    const auto there = file.places.find({static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
    if (there == file.places.end()) return false;
    v = there->second;
  }
  return true;
}

/// `node` takes the mesh into the file's frame. A scale that mirrors turns the corners of triangles round.
void add_mesh(MeshShape& to, const aiMesh& from, const Affine& node) {
  const auto first = static_cast<std::uint32_t>(to.vertices.size());
  const bool mirrors = node.mirrors();
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    const aiVector3D& at = from.mVertices[i];
    to.vertices.push_back(node({at.x, at.y, at.z}));
  }
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines have no area
    const unsigned* corner = face.mIndices;
    PHYSIM_ASSERT(corner[0] < from.mNumVertices);
    to.triangles.push_back({first + corner[0], first + corner[mirrors ? 2 : 1], first + corner[mirrors ? 1 : 2]});
  }
}

Affine affine_of(const aiMatrix4x4& m) {
  return {{m.a1, m.b1, m.c1}, {m.a2, m.b2, m.c2}, {m.a3, m.b3, m.c3}, {m.a4, m.b4, m.c4}};
}

/// `nodes`: the transforms of nodes by name, instead of Assimp's own; may be null.
void add_node(MeshShape& to, const aiScene& scene, const aiNode& node, const Affine& parent, const GltfNodes* nodes) {
  const Affine* known = nodes != nullptr ? nodes->find(node.mName.C_Str()) : nullptr;
  const Affine here = known != nullptr ? *known : parent.after(affine_of(node.mTransformation));
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    PHYSIM_ASSERT(node.mMeshes[i] < scene.mNumMeshes);
    add_mesh(to, *scene.mMeshes[node.mMeshes[i]], here);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(to, scene, *node.mChildren[i], here, nodes);
}

/// Reads the file itself, or the text `instead`, which may be null.
Result<MeshShape> read_mesh(const std::string& file, const std::string* instead = nullptr,
                            const GltfNodes* nodes = nullptr) {
  Status files;
  Assimp::Importer importer;
  importer.SetIOHandler(new MeshFiles(files, file, instead));  // the importer owns it
  // Corners are joined where they differ in nothing but what is not read.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                                          aiComponent_COLORS | aiComponent_TEXCOORDS |
                                                          aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                                          aiComponent_TEXTURES | aiComponent_LIGHTS |
                                                          aiComponent_CAMERAS | aiComponent_MATERIALS);
  const aiScene* scene =
      importer.ReadFile(file, aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_JoinIdenticalVertices);
  if (!files) return files.error();
  if (scene == nullptr) return Error{"Assimp: " + std::string(importer.GetErrorString()), file, ""};
  MeshShape mesh;
  if (scene->mRootNode != nullptr) add_node(mesh, *scene, *scene->mRootNode, {}, nodes);
  if (mesh.triangles.empty()) return Error{"there are no triangles in it", file, ""};
  return mesh;
}

}  // namespace

Result<MeshShape> read_mesh_file(const std::string& file) {
  const IeeeMode mode;
  if (const Status status = check_file(file, kLargestMesh, "mesh"); !status) return status.error();
  // Assimp's numbers are floats: it reads whole numbers instead of the digits of a text file, and glTF without the
  // transforms of its nodes.
  const auto text = read_text_file(file, kLargestMesh, "mesh");
  if (const auto numbered = text ? numbered_mesh(*text) : std::nullopt)
    if (auto mesh = read_mesh(file, &numbered->text); mesh && put_in_place(*mesh, *numbered)) return mesh;
  if (const auto plain = text ? gltf_nodes(*text) : std::nullopt)
    if (auto mesh = read_mesh(file, &plain->text, &*plain)) return mesh;
  return read_mesh(file);
}

#else

Result<MeshShape> read_mesh_file(const std::string& file) {
  return Error{"this build reads no meshes from files", file,
               "build it with Assimp (libassimp-dev), or write vertices and triangles into the scenario"};
}

#endif

}  // namespace physim
