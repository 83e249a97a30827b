// Source: Khronos Group, glTF 2.0 Specification (2021), sections 3.5.3 (transformations) and 4.4 (binary files).
#include "scenario/gltf_nodes.hpp"

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>

namespace physim {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kFileHeader = 12, kChunkHeader = 8;  // of a binary file [bytes]
static_assert(std::endian::native == std::endian::little, "binary glTF has its words so");

std::uint32_t word_at(const std::string& text, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, text.data() + at, sizeof word);
  return word;
}
std::string as_bytes(std::size_t number) {
  const auto word = static_cast<std::uint32_t>(number);
  std::string bytes(sizeof word, '\0');
  std::memcpy(bytes.data(), &word, sizeof word);
  return bytes;
}

/// The numbers of a key, `otherwise` where the node lacks it; nothing if it has another count of numbers.
std::optional<std::vector<double>> numbers_of(const Json& node, const char* key, std::vector<double> otherwise) {
  if (!node.contains(key)) return otherwise;
  const Json& list = node[key];
  if (!list.is_array() || list.size() != otherwise.size()) return std::nullopt;
  for (const Json& each : list)
    if (!each.is_number()) return std::nullopt;
  return list.get<std::vector<double>>();
}

/// The transform of a node into the frame of its parent: a matrix by columns, or translation, rotation and scale.
std::optional<Affine> own_transform(const Json& node) {
  if (!node.is_object()) return std::nullopt;
  const auto matrix = numbers_of(node, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  const auto translation = numbers_of(node, "translation", {0, 0, 0}), scale = numbers_of(node, "scale", {1, 1, 1});
  const auto rotation = numbers_of(node, "rotation", {0, 0, 0, 1});
  if (!matrix || !translation || !scale || !rotation) return std::nullopt;
  const auto column = [](const std::vector<double>& from, std::size_t i) {
    return Vec3d{from[i], from[i + 1], from[i + 2]};
  };
  if (node.contains("matrix"))
    return Affine{column(*matrix, 0), column(*matrix, 4), column(*matrix, 8), column(*matrix, 12)};
  const Quatd turn{(*rotation)[3], (*rotation)[0], (*rotation)[1], (*rotation)[2]};
  return Affine{rotate(turn, Vec3d{(*scale)[0], 0, 0}), rotate(turn, Vec3d{0, (*scale)[1], 0}),
                rotate(turn, Vec3d{0, 0, (*scale)[2]}), column(*translation, 0)};
}

/// The parent of each node; its number for a root. Nothing if a node has two parents or a child that is no node.
std::optional<std::vector<std::size_t>> parents_of(const Json& nodes) {
  std::vector<std::size_t> parents(nodes.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].contains("children")) continue;
    for (const Json& child : nodes[i]["children"]) {
      if (!child.is_number_unsigned()) return std::nullopt;
      const auto at = child.get<std::size_t>();
      if (at >= nodes.size() || at == i || parents[at] != at) return std::nullopt;
      parents[at] = i;
    }
  }
  return parents;
}

/// Takes transforms from the frames of parents into that of the file. False if the nodes are no trees.
bool take_to_file(const Json& nodes, std::vector<Affine>& transforms) {
  const auto parents = parents_of(nodes);
  if (!parents) return false;
  std::vector<bool> is_done(nodes.size());
  std::vector<std::size_t> up;  // from a node to the first one that is done, or to a root
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    up.clear();
    for (std::size_t at = i; !is_done[at]; at = (*parents)[at]) {
      if (up.size() > nodes.size()) return false;  // they go round in a circle
      up.push_back(at);
      if ((*parents)[at] == at) break;
    }
    for (; !up.empty(); up.pop_back()) {
      const std::size_t at = up.back(), parent = (*parents)[at];
      if (parent != at) transforms[at] = transforms[parent].after(transforms[at]);
      is_done[at] = true;
    }
  }
  return true;
}

/// The JSON of a text; nothing if it is none, or so deep that what walks through it would need too much memory.
Json parsed(std::string_view text) {
  constexpr int kDeepest = 500;
  bool is_deep = false;
  const auto look = [&](int depth, Json::parse_event_t, const Json&) { return !(is_deep |= depth > kDeepest); };
  Json json = Json::parse(text, look, false);
  return is_deep ? Json(Json::value_t::discarded) : json;
}

}  // namespace

const Affine* GltfNodes::find(const std::string& name) const {
  std::size_t number = nodes.size();
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool is_number = read.ec == std::errc() && read.ptr == name.data() + name.size();
  return is_number && number < nodes.size() ? &nodes[number] : nullptr;
}

std::optional<GltfNodes> gltf_nodes(const std::string& text) {
  const bool is_binary = text.starts_with("glTF") && text.size() >= kFileHeader + kChunkHeader;
  const std::size_t begin = is_binary ? kFileHeader + kChunkHeader : 0;
  const std::size_t size = is_binary ? word_at(text, kFileHeader) : text.size();
  if ((!is_binary && !text.starts_with('{')) || size > text.size() - begin) return std::nullopt;
  Json file = parsed(std::string_view(text).substr(begin, size));
  if (!file.is_object() || !file.contains("asset") || !file.contains("nodes") || !file["nodes"].is_array())
    return std::nullopt;
  GltfNodes out;
  Json& nodes = file["nodes"];
  for (const Json& node : nodes) {
    const auto transform = own_transform(node);
    if (!transform) return std::nullopt;
    out.nodes.push_back(*transform);
  }
  if (!take_to_file(nodes, out.nodes)) return std::nullopt;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const char* key : {"matrix", "translation", "rotation", "scale"}) nodes[i].erase(key);
    nodes[i]["name"] = std::to_string(i);
  }
  out.text = file.dump();
  if (!is_binary) return out;
  out.text.resize((out.text.size() + 3) / 4 * 4, ' ');
  const std::string rest = text.substr(begin + size);
  out.text = text.substr(0, 8) + as_bytes(begin + out.text.size() + rest.size()) + as_bytes(out.text.size()) +
             text.substr(kFileHeader + 4, 4) + out.text + rest;
  return out;
}

}  // namespace physim
