#include "study_columns.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "physim/result.hpp"
#include "report/file.hpp"
#include "report/study_answer.hpp"
#include "scenario/libraries.hpp"
#include "scenario/new_file.hpp"
#include "scenario/text_file.hpp"

#if PHYSIM_HAS_HDF5
#include <hdf5.h>
#endif

namespace physim::cli {

#if PHYSIM_HAS_HDF5

namespace {

/// Something of HDF5 that is closed when it goes.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*how)(hid_t)) : id_(id), close_(how) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { static_cast<void>(close()); }

  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool good() const { return id_ >= 0; }
  /// False where what is closed could not be written.
  bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// A column of a file, written from its first row on.
struct Column {
  Handle data;
  hid_t type;  // of the numbers in memory
};

/// The file while it is written. The first call that fails makes it bad.
class ColumnsFile {
 public:
  ColumnsFile(const std::string& file, std::uint64_t rows, std::uint64_t rows_at_once) : rows_(rows) {
    H5dont_atexit();                              // a file that could not be closed would end the program in a fault
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // what goes wrong is told by us
    errno = 0;
    file_ = Handle(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    const hsize_t all = rows, chunk = rows_at_once;
    space_ = Handle(H5Screate_simple(1, &all, nullptr), H5Sclose);
    how_ = Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    good_ = file_.good() && space_.good() && how_.good() && H5Pset_chunk(how_.id(), 1, &chunk) >= 0;
    keep_error();
  }

  void say(const char* name, const std::string& text) { add_text(file_.id(), name, text); }
  void say(const char* name, std::uint64_t number) {
    const Handle one(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(H5Acreate2(file_.id(), name, H5T_STD_U64LE, one.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(attribute.good() && H5Awrite(attribute.id(), H5T_NATIVE_UINT64, &number) >= 0);
  }
  void add_group(const char* name) {
    const Handle group(H5Gcreate2(file_.id(), name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    check(group.good());
  }
  /// Names that are taken, or have what HDF5 takes for a path, are written otherwise.
  Column add(const std::string& group, std::string name, const std::string& unit, hid_t file_type, hid_t type) {
    std::ranges::replace(name, '/', '_');
    if (name.empty() || name == ".") name = "unnamed";
    std::string path = group + "/" + name;
    for (int copy = 2; H5Lexists(file_.id(), path.c_str(), H5P_DEFAULT) > 0; ++copy)
      path = group + "/" + name + " (" + std::to_string(copy) + ")";
    Column column{
        Handle(H5Dcreate2(file_.id(), path.c_str(), file_type, space_.id(), H5P_DEFAULT, how_.id(), H5P_DEFAULT),
               H5Dclose),
        type};
    check(column.data.good());
    add_text(column.data.id(), "unit", unit);
    return column;
  }
  void write(const Column& column, std::uint64_t first, std::uint64_t count, const void* numbers) {
    PHYSIM_ASSERT(first + count <= rows_);
    const hsize_t from = first, many = count;
    const Handle memory(H5Screate_simple(1, &many, nullptr), H5Sclose), place(H5Scopy(space_.id()), H5Sclose);
    check(memory.good() && place.good() &&
          H5Sselect_hyperslab(place.id(), H5S_SELECT_SET, &from, nullptr, &many, nullptr) >= 0 &&
          H5Dwrite(column.data.id(), column.type, memory.id(), place.id(), H5P_DEFAULT, numbers) >= 0);
  }
  void finish() {
    check(H5Fflush(file_.id(), H5F_SCOPE_LOCAL) >= 0);
    check(file_.close());
  }
  [[nodiscard]] bool good() const { return good_; }
  /// The number of the system's error when it became bad; 0: it told none.
  [[nodiscard]] int error_number() const { return error_; }

 private:
  void check(bool fine) {
    if (!good_ || fine) return;
    good_ = false;
    keep_error();
  }
  void keep_error() {
    if (!good_) error_ = errno;
  }
  void add_text(hid_t to, const char* name, const std::string& text) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose), one(H5Screate(H5S_SCALAR), H5Sclose);
    H5Tset_size(type.id(), text.size() + 1);
    H5Tset_cset(type.id(), H5T_CSET_UTF8);
    const Handle attribute(H5Acreate2(to, name, type.id(), one.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(attribute.good() && H5Awrite(attribute.id(), type.id(), text.c_str()) >= 0);
  }

  std::uint64_t rows_;
  Handle file_, space_, how_;
  bool good_ = false;
  int error_ = 0;
};

/// All columns of a study.
class StudyColumns {
 public:
  StudyColumns(ColumnsFile& file, const StudyPlan& plan) : StudyColumns(file, plan.study(), "") {
    file.add_group("inputs");
    for (const StudyInput& input : plan.study().inputs)
      inputs_.push_back(file.add("inputs", input.path, report::unit_of(input), H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE));
    const std::vector<StudyPlan> places = plan.places();
    if (!places.empty()) file.add_group("at");
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::string place = place_text(plan.study().at[i].event);
      std::ranges::replace(place, '/', '_');  // which HDF5 takes for a path
      const std::string group = "at/" + place;
      file.add_group(group.c_str());
      at_.push_back(StudyColumns(file, places[i].study(), group + "/"));
    }
  }

  void write(std::uint64_t first, const StudyShots& shots) {
    PHYSIM_ASSERT(shots.inputs.size() == inputs_.size() && shots.hits.size() == hits_.size() &&
                  shots.at.size() == at_.size());
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      file_.write(inputs_[i], first, shots.inputs[i].size(), shots.inputs[i].data());
    for (std::size_t i = 0; i < quantities_.size(); ++i)
      file_.write(quantities_[i], first, shots.quantities[i].size(), shots.quantities[i].data());
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      const std::vector<std::uint8_t> hits(shots.hits[i].begin(), shots.hits[i].end());
      file_.write(hits_[i], first, hits.size(), hits.data());
    }
    for (std::size_t i = 0; i < at_.size(); ++i) at_[i].write(first, shots.at[i]);
  }

 private:
  /// Columns of where shots ended, or were at a place whose group is `below` that of the file.
  StudyColumns(ColumnsFile& file, const Study& study, const std::string& below) : file_(file) {
    const std::string quantities = below + "quantities", hits = below + "hits";
    file.add_group(quantities.c_str());
    for (const StudyQuantity quantity : study.quantities)
      quantities_.push_back(file.add(quantities, std::string(name(quantity)), std::string(unit_of(quantity)),
                                     H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE));
    if (!study.targets.empty()) file.add_group(hits.c_str());
    for (const StudyTarget& target : study.targets)
      hits_.push_back(file.add(hits, target.name, "1: hit", H5T_STD_U8LE, H5T_NATIVE_UINT8));
  }

  ColumnsFile& file_;
  std::vector<Column> inputs_, quantities_, hits_;
  std::vector<StudyColumns> at_;  // of each place
};

/// Shards are flown on all threads, and written in their order by this one.
void write_shards(ColumnsFile& file, const StudyPlan& plan, std::uint64_t shards, TaskRunner& threads) {
  StudyColumns columns(file, plan);
  struct Block {
    const StudyPlan& plan;
    std::uint64_t first;
    std::vector<StudyShots> shots;
  };
  const std::uint64_t at_once = std::max<std::uint64_t>(threads.threads(), 1);
  for (std::uint64_t first = 0; first < shards && file.good(); first += at_once) {
    Block block{plan, first, std::vector<StudyShots>(std::min(at_once, shards - first))};
    threads.run(
        block.shots.size(),
        [](void* self, std::size_t i) {
          Block& of = *static_cast<Block*>(self);
          of.shots[i] = fly_shots_of(of.plan, of.first + i);
        },
        &block);
    for (std::size_t i = 0; i < block.shots.size(); ++i)
      columns.write((first + i) * plan.study().shard_shots, block.shots[i]);
  }
}

}  // namespace

Status check_columns_file(const std::string& file) {
  if (file == "-" || is_special(target_of(file)))
    return Error{"HDF5 is written into a file of its own, and not into a stream", "--hdf5", "name a file"};
  return report::check_writable(file);
}

Status write_columns(const std::string& file, const std::string& title, const StudyPlan& plan, std::uint64_t shards,
                     TaskRunner& threads) {
  if (Status status = check_columns_file(file); !status) return status;
  const Study& study = plan.study();
  NewFile place(file);
  if (Status status = place.open(); !status) return status;
  ColumnsFile columns(place.written(), shards * study.shard_shots, study.shard_shots);
  if (columns.good()) {
    columns.say("title", title);
    columns.say("physim", std::string(kVersion));
    columns.say("sampling", std::string(name(study.sampling)));
    columns.say("seed", study.seed);
    columns.say("shots", shards * study.shard_shots);
    columns.say("rounds", study.rounds);
    write_shards(columns, plan, shards, threads);
    columns.finish();
  }
  if (columns.good()) return place.complete();
  const int error_number = columns.error_number();
  return Error{"cannot write: " + std::string(error_number == 0 ? "HDF5 failed" : std::strerror(error_number)), file,
               "is there room for " + std::to_string(shards * study.shard_shots) + " shots?"};
}

#else

Status check_columns_file(const std::string&) {
  return Error{"this physim was built without HDF5", "--hdf5",
               "build it where HDF5 is, on Debian libhdf5-dev; or write figures with --csv"};
}
Status write_columns(const std::string& file, const std::string&, const StudyPlan&, std::uint64_t, TaskRunner&) {
  return check_columns_file(file);
}

#endif

}  // namespace physim::cli
