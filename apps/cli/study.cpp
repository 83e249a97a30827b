// physim study: how likely each end of a shot is, whose numbers are uncertain.
#include "physim/study.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "asked.hpp"
#include "outputs.hpp"
#include "physim/result.hpp"
#include "report/gnuplot.hpp"
#include "report/number.hpp"
#include "report/study_answer.hpp"
#include "report/study_pictures.hpp"
#include "report/table.hpp"
#include "scenario/mistakes.hpp"
#include "scenario/study_text.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "study/quantities.hpp"
#include "study_columns.hpp"
#include "study_part_files.hpp"
#include "study_progress.hpp"
#include "study_ranks.hpp"
#include "terminal.hpp"

namespace physim::cli {
namespace {

struct StudyCommand {
  Question question;
  std::optional<std::uint64_t> shots, over_inputs, histograms, fly;
  std::optional<std::uint32_t> threads;
  std::vector<std::string> vary, targets, at, merge;
  std::string range, ranges, width, time, csv, plot, kml, hdf5, resume, shards, log_every;
  double log_seconds = 60;
};

/// "17/512": the 17th of 512 parts of the shards.
struct ShardRange {
  std::uint64_t first, count;
};
Result<ShardRange> shards_of(const std::string& text, std::uint64_t all) {
  const Error unreadable{"\"" + text + "\" is no part of the shards", "--shards",
                         "as in 17/512, from 1/512 to 512/512"};
  const char *begin = text.data(), *end = begin + text.size();
  std::uint64_t number = 0, parts = 0;
  const auto [slash, bad_number] = std::from_chars(begin, end, number);
  if (bad_number != std::errc() || slash == end || *slash != '/') return unreadable;
  const auto [rest, bad_parts] = std::from_chars(slash + 1, end, parts);
  if (bad_parts != std::errc() || rest != end || number < 1 || number > parts || parts > (1u << 30)) return unreadable;
  const auto begin_of = [&](std::uint64_t part) { return all / parts * part + all % parts * part / parts; };
  return ShardRange{begin_of(number - 1), begin_of(number) - begin_of(number - 1)};
}

// ----------------------------------------------------------------------------------------------------------- studies
/// A study of a time has as many shots as fit, unless the command itself says how many.
Status add_time(const StudyCommand& command, ScenarioStudy& study) {
  constexpr std::int64_t kMostShots = 1'000'000'000'000'000;
  const auto time = option_value("--until-time", command.time, Quantity::time);
  if (!time) return time.error();
  if (*time) study.until_time = *time;
  if (!study.until_time) return {};
  if (!(*study.until_time > 0)) return Error{"must be above 0", "--until-time", "as in \"30 s\" or \"2 h\""};
  if (!command.shards.empty())
    return Error{"a part of a study is flown to its end, however long it takes", "--shards",
                 "leave --until-time and study.until_time out"};
  if (!command.shots) study.shots = kMostShots;
  return {};
}

/// What the options say besides the file.
Status add_options(const StudyCommand& command, Scenario& scenario) {
  const auto add = [&](const char* option, const char* list, const auto& from, auto& to) {
    for (const std::string& text : from) {
      scenario.study.places.push_back({list + ('[' + std::to_string(to.size()) + ']'), option});
      to.push_back(text);
    }
  };
  add("--vary", "inputs", command.vary, scenario.study.inputs);
  add("--target", "targets", command.targets, scenario.study.targets);
  add("--at", "at", command.at, scenario.study.at);
  if (command.shots) scenario.study.shots = static_cast<std::int64_t>(*command.shots);
  const auto range = option_value("--range", command.range, Quantity::length);
  if (!range) return range.error();
  if (*range) scenario.until.range = **range;
  if (command.over_inputs) {
    if (*command.over_inputs > 100) return Error{"must be from 2 to 100 parts", "--over-inputs", ""};
    scenario.study.over_inputs = static_cast<std::int64_t>(*command.over_inputs);
  }
  if (command.histograms) scenario.study.histograms = static_cast<std::int64_t>(*command.histograms);
  return add_time(command, scenario.study);
}

/// The hit probability of the first target, or the mean of the first quantity, to a width.
Status add_width(const StudyCommand& command, Study& study) {
  if (command.width.empty()) return {};
  const bool hits = !study.targets.empty();
  const StudyQuantity first = study.quantities.empty() ? StudyQuantity::right : study.quantities.front();
  const Quantity quantity = hits ? Quantity::number : quantity_of_si_unit(unit_of(first));
  const auto width = option_value("--until-width", command.width, quantity);
  if (!width) return width.error();
  if (hits && !(**width < 1))
    return Error{"an interval of a hit probability is less than 1 wide", "--until-width", "as in \"1 %\""};
  study.until_width = StudyWidth{.width = **width};
  if (hits) study.until_width->target = 0;
  return {};
}

/// What a large study takes, as its first shard tells.
void tell_length(const StudyPlan& plan, std::uint64_t missing, unsigned threads, const char* flyers) {
  constexpr std::uint64_t kMany = 20'000;
  if (missing < kMany) return;
  const auto start = std::chrono::steady_clock::now();
  static_cast<void>(run_shard(plan, 0));
  const std::chrono::duration<double> shard = std::chrono::steady_clock::now() - start;
  const double all = shard.count() * static_cast<double>(missing) / threads;
  print_warning(std::to_string(missing) + " shards of " + std::to_string(plan.study().shard_shots) +
                " shots take about " + duration_text(all) + " on " + std::to_string(threads) + " " + flyers);
}

/// How long a study may fly; without a time as long as it takes.
class TimeToFly {
 public:
  explicit TimeToFly(std::optional<double> seconds) : seconds_(seconds) {}

  [[nodiscard]] bool is_limited() const { return seconds_.has_value(); }
  [[nodiscard]] bool is_up() const { return seconds_ && passed() >= *seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double passed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  std::optional<double> seconds_;
  Clock::time_point start_ = Clock::now();
};

StudyOptions options_of(StudyProgress& progress, PartKeeper& keeper, const StudyPart& so_far, const TimeToFly& time) {
  StudyOptions options{.so_far = so_far, .after_shard = [&](const StudyPart& part) {
                         progress.show(part);
                         return keeper.take(part);
                       }};
  if (time.is_limited()) options.time_is_up = [&time] { return time.is_up(); };
  return options;
}

/// A job that failed says what is left of its work.
Error with_what_is_kept(Error error, const StudyPart& part, const std::string& file) {
  const std::string shards = std::to_string(part.shards()) + " shards";
  const std::string left = file.empty() ? shards + " are lost: give --resume FILE to keep them"
                                        : shards + " are in " + file + ": go on with --resume " + file;
  error.hint += (error.hint.empty() ? "" : "; ") + left;
  return error;
}

/// Told before, since mpirun passes on nothing that ranks say once one of them died.
void tell_of_ranks(unsigned ranks, const std::string& file) {
  std::fprintf(stderr, "%u ranks fly this study; should one die, %s\n", ranks,
               file.empty() ? "all is lost: --resume FILE keeps what is flown"
                            : ("go on with --resume " + file + ", which has all but the last second").c_str());
}

[[noreturn]] void end_now(const Error& error, const StudyPartRecord& flown, const std::string& file,
                          PartKeeper& keeper) {
  const StudyPart part(std::make_shared<const StudyPartRecord>(flown));
  print_error(keeper.write(part) ? with_what_is_kept(error, part, file) : keeper.status().error());
  std::_Exit(kExitBadInput);
}

/// On the ranks of a job where there are several, else on threads.
Result<StudyResult> fly_on(Ranks& ranks, TaskRunner& threads, const StudyPlan& plan, const StudyOptions& options,
                           const std::string& file, PartKeeper& keeper) {
  if (ranks.count() == 1) return run_study(plan, &threads, options);
  auto result = run_study_on(plan, options.so_far, [&](StudyPartRecord& part, std::uint64_t end) {
    const Flown flown = ranks.fly(plan, part, end, options);
    if (ranks.was_ended()) end_now(ranks.failed().error(), part, file, keeper);
    return flown;
  });
  if (!ranks.failed()) return ranks.failed().error();
  return result;
}

Result<FlownStudy> fly_study(const Study& study, const ScenarioStudy& texts, TaskRunner& threads, Ranks& ranks,
                             const StudyCommand& command) {
  const std::optional<double> until_time = texts.until_time;
  const auto plan = plan_study(study);
  if (!plan) return plan.error();
  for (const std::string& note : notes_of(*plan)) print_warning(note);
  const auto before = flown_before(command.merge, command.resume, *plan);
  if (!before) return before.error();
  const bool joins_only = !command.merge.empty() && command.resume.empty() && !study.until_width && !until_time;
  if (joins_only)
    if (const auto whole = result_of(*plan, *before, plan->shards()); !whole) return whole.error();
  const bool alone = ranks.count() == 1;
  if (!alone) tell_of_ranks(ranks.count(), command.resume);
  if (!until_time)
    tell_length(*plan, plan->shards() - std::min(plan->shards(), before->shards()),
                alone ? threads.threads() : ranks.count(), alone ? "threads" : "ranks");
  PartKeeper keeper(command.resume);
  StudyProgress progress(*plan, *before, command.log_seconds, until_time);
  const TimeToFly time(until_time);
  StudyOptions options = options_of(progress, keeper, *before, time);
  StudyPart last = *before;
  options.after_shard = [&, take = options.after_shard](const StudyPart& part) { return last = part, take(part); };
  auto result = fly_on(ranks, threads, *plan, options, command.resume, keeper);
  keeper.write(last);
  if (!keeper.status()) return keeper.status().error();
  if (!ranks.failed()) return with_what_is_kept(ranks.failed().error(), last, command.resume);
  if (!result) return result.error();
  return told_study(*plan, *std::move(result), static_cast<std::size_t>(texts.histograms), texts.inputs);
}

/// An error about the study of a shot, at the option or the text that it is about.
Error about_study(const StudyCommand& command, const AskedShot& asked, const Error& error) {
  const char* option = option_of(error, {{"--shots", command.shots.has_value(), "shots"},
                                         {"--over-inputs", command.over_inputs.has_value(), "over_inputs"},
                                         {"--histograms", command.histograms.has_value(), "study.histograms"},
                                         {"--until-width", !command.width.empty(), "until_width.width"},
                                         {"--range", !command.range.empty(), "until.range"},
                                         {"--ranges", !command.ranges.empty(), "until.range"}});
  if (option != nullptr) return {error.message, option, error.hint};
  Error in_text = in_study(asked.scenario, asked.shot(), error);
  if (in_text.place != error.place) return in_text;
  in_text.place = setting_of_study(error.place);
  return about(asked, in_text);
}

/// Inputs of another shot are those of another study.
void warn_of_other_shots(const StudyCommand& command, const AskedShot& asked) {
  const std::size_t first = asked.scenario.study.inputs.size() - command.vary.size();  // --vary stands behind the file
  const std::vector<InputOfShot> inputs = inputs_of(asked.scenario, asked.shot());
  for (std::size_t i = 0; i < command.vary.size(); ++i)
    if (std::ranges::find(inputs, first + i, &InputOfShot::text) == inputs.end())
      print_warning("--vary " + in_quotes(command.vary[i]) + ": has no effect: the study is of shot " +
                    in_quotes(asked.shot().projectile.name));
}

struct AskedStudy {
  AskedShot asked;
  Study study;
};
Result<AskedStudy> ask_study(const StudyCommand& command) {
  Question question = command.question;
  question.input.ranges = command.ranges;
  question.input.has_complete_study = command.vary.empty();
  Result<AskedShot> asked = ask(question);
  if (!asked) return asked.error();
  warn_of_fidelity(asked->shot(), "a study");
  if (Status status = add_options(command, asked->scenario); !status) return status.error();
  std::vector<Error> errors;
  Study study = read_study(asked->scenario, asked->shot(), errors);
  Mistakes mistakes;
  for (const Error& error : errors) mistakes.take(about_study(command, *asked, error));
  if (Status status = mistakes.status(); !status) return status.error();
  if (Status status = add_width(command, study); !status) return status.error();
  return AskedStudy{*std::move(asked), std::move(study)};
}

/// What other ranks of a job do: they fly what the first tells them to.
Result<int> serve(const StudyCommand& command, Ranks& ranks) {
  const auto asked = ask_study(command);
  const auto plan = asked ? plan_study(asked->study) : asked.error();
  if (plan)
    ranks.serve(*plan);
  else
    ranks.give_up(plan.error());
  return kExitOk;  // the first rank says what is wrong; a launcher ends all ranks when one does
}

/// One of the parts of an array of jobs: flown into its file, and nothing more.
Result<int> run_part(const StudyCommand& command, const AskedShot& asked, const Study& study, TaskRunner& threads) {
  if (command.resume.empty()) return Error{"a part of a study goes into a file", "--shards", "give --resume FILE"};
  const auto plan = plan_study(study);
  if (!plan) return about_study(command, asked, plan.error());
  const auto range = shards_of(command.shards, plan->shards());
  if (!range) return range.error();
  const auto before = flown_before(command.merge, command.resume, *plan);
  if (!before) return before.error();
  PartKeeper keeper(command.resume);
  StudyProgress progress(*plan, *before, command.log_seconds, {});
  const TimeToFly as_long_as_it_takes({});
  const auto part = run_shards(*plan, range->first, range->count, &threads,
                               options_of(progress, keeper, *before, as_long_as_it_takes));
  if (!part) return part.error();
  if (!keeper.write(*part)) return keeper.status().error();
  return done(print(std::to_string(keeper.kept().shards()) + " of " + std::to_string(plan->shards()) +
                    " shards are in " + command.resume + "\n"));
}

void warn_of_width() { print_warning("the width of --until-width is not reached: give more --shots"); }

/// Holds the sight off for what is known of wind and drift: the shot with the mean of each input hits the aim. Targets
/// on the plane move with the impacts. Returns the correction.
Result<PlanePoint> hold(Study& study) {
  const auto plan = plan_study(study);
  if (!plan) return plan.error();
  const std::vector<StudyQuantity>& axes = plan->study().quantities;
  if (axes.size() < 2 || axes[0] != StudyQuantity::right || axes[1] != StudyQuantity::up) return PlanePoint{};
  const auto known = propagate_linearly(*plan);
  if (!known) return PlanePoint{};    // the mean shot does not arrive
  constexpr double kSmallest = 1e-5;  // of corrections [m]
  const PlanePoint off{known->mean[0] - study.aim.right, known->mean[1] - study.aim.up};
  if (std::hypot(off.right, off.up) < kSmallest) return PlanePoint{};
  const auto move = [&](PlanePoint& point) { point = {point.right + off.right, point.up + off.up}; };
  move(study.aim);
  for (StudyTarget& target : study.targets)
    std::visit(
        [&](auto& shape) {
          if constexpr (requires { shape.centre; }) move(shape.centre);
          if constexpr (requires { shape.corners; }) std::ranges::for_each(shape.corners, move);
        },
        target.shape);
  return PlanePoint{-off.right, -off.up};
}

/// A table over range has the plane of impact, and the spread about the centre of the impacts.
void warn_of_what_ranges_leave_out(const ScenarioStudy& texts) {
  for (const GivenSetting& given : texts.places)
    if (given.path == "aim" || given.path == "quantities")
      print_warning(given.place + ": study." + given.path + ": has no effect with --ranges");
}

/// The study at a range. A shot that is zeroed is zeroed there, as a shooter does who knows the range.
Result<StudyAtRange> fly_to(double range, Study study, const ScenarioStudy& texts, TaskRunner& threads, Ranks& ranks,
                            const StudyCommand& command) {
  PlanePoint held;
  if (study.launch.sight.zero_range > 0) {
    study.launch.sight.zero_range = range;
    study.launch.sight.dial = 0;  // it is that of one range
    const auto known = hold(study);
    if (!known) return known.error();
    held = *known;
  }
  auto flown = fly_study(study, texts, threads, ranks, command);
  if (!flown) return flown.error();
  return StudyAtRange{range, std::move(flown->result), held};
}

/// True of an error that says that a shot does not get so far, by its flight or by its zero.
bool is_out_of_reach(const Error& error) { return error.place == "until" || error.place == "launch.sight.zero_range"; }

/// The study at each range, and "not reached" for those that no shot comes to.
Result<int> run_over_ranges(const StudyCommand& command, const AskedShot& asked, Study study, TaskRunner& threads,
                            Ranks& ranks) {
  if (!study.at.empty())
    return Error{"ranges are flown to one after the other, and places are told of the same flights", "--ranges",
                 "leave it out, or study.at and --at"};
  if (asked.scenario.study.histograms > 0)
    return Error{"histograms are told of one study", "--ranges",
                 "leave --ranges out (--at tells of ranges, too), or study.histograms and --histograms"};
  if (asked.scenario.study.over_inputs > 0)
    return Error{"hits are told over range or over inputs", "--ranges",
                 "leave --ranges out, or study.over_inputs and --over-inputs"};
  if (study.indices) return Error{"indices are told of one study", "--ranges", "leave --ranges out, or study.indices"};
  if (!std::ranges::all_of(asked.scenario.ranges, [](double range) { return range > 0; }))
    return Error{"a study is flown to ranges above 0", "--ranges", "as in \"100 m .. 1000 m step 100 m\""};
  warn_of_what_ranges_leave_out(asked.scenario.study);
  std::vector<StudyAtRange> list;
  std::vector<double> missed;
  std::optional<Error> out_of_reach;  // the first
  StudyCommand alone;
  alone.log_seconds = command.log_seconds;
  bool misses = false;
  for (const double range : asked.scenario.ranges) {
    study.until.range = range;
    auto at = fly_to(range, study, asked.scenario.study, threads, ranks, alone);
    if (!at && is_out_of_reach(at.error())) {
      missed.push_back(range);
      const std::string place = place_text(EventSpec{.kind = EventKind::range, .value = range});
      if (!out_of_reach) out_of_reach = Error{place + ": " + at.error().message, "--ranges", at.error().hint};
      continue;
    }
    if (!at) return about_study(command, asked, at.error());
    misses = misses || misses_width(study, at->result);
    list.push_back(*std::move(at));
  }
  if (list.empty()) return *out_of_reach;
  if (misses) warn_of_width();
  const std::string title = title_of_shot(asked);
  if (!command.plot.empty())
    if (Status status = draw(command.plot, ranges_picture(title, list)); !status) return status.error();
  if (command.csv != "-")
    if (Status status = print(style_of(stdout).bold(title) + "\n" +
                              over_range_text(list, last_unit(command.ranges, Quantity::length), missed));
        !status)
      return status.error();
  return done(command.csv.empty() ? Status() : write_output(command.csv, csv_text(records_of(list, missed))),
              misses || !missed.empty() ? kExitCheckMissed : kExitOk);
}

Status check_command(const StudyCommand& command) {
  const bool in_parts = !command.resume.empty() || !command.merge.empty() || !command.shards.empty();
  if (command.fly && (in_parts || !(command.csv + command.kml + command.plot + command.hdf5 + command.ranges).empty()))
    return Error{"one shot is flown again and told alone", "--fly", "leave out files, --ranges and what joins parts"};
  if (!command.ranges.empty() && !command.range.empty())
    return Error{"given together with --ranges", "--range", "give one of them"};
  if (!command.ranges.empty() && in_parts)
    return Error{"a study over ranges is not flown in parts", "--ranges", "give --range, and fly one after the other"};
  if (!command.ranges.empty() && !command.question.json.empty())
    return Error{"a study over ranges writes CSV alone", "--json", "give --csv"};
  if (!command.ranges.empty() && !command.kml.empty())
    return Error{"a map is of shots that come down on the ground", "--kml", "leave --ranges out"};
  if (!command.shards.empty() && !(command.plot.empty() && command.kml.empty()))
    return Error{"a part of a study is not drawn", "--shards", "draw the whole, where the parts are joined"};
  if (!command.hdf5.empty()) {
    if (!command.ranges.empty() || !command.shards.empty())
      return Error{"shots are written of one study that is flown whole", "--hdf5",
                   "leave --ranges and --shards out; --merge joins parts"};
    if (Status status = check_columns_file(command.hdf5); !status) return status;
  }
  for (const std::string& file : {command.csv, command.kml, command.resume})
    if (!file.empty())
      if (Status status = check_output(file); !status) return status;
  return command.plot.empty() ? Status() : check_plot(command.plot);
}

Picture picture_of(const std::string& title, const FlownStudy& flown) {
  if (!flown.result.over_inputs.empty()) return over_inputs_picture(title, flown);
  return flown.histogram_bars > 0 ? histograms_picture(title, flown) : study_picture(title, flown);
}

/// "out/308-ranges.png" beside "out/308.png".
std::string beside(const std::string& file, const std::string& what) {
  const std::filesystem::path path(file);
  std::filesystem::path other = path;
  return other.replace_filename(path.stem().string() + "-" + what + path.extension().string()).string();
}

/// One picture; where it shows hits over inputs, histograms that are asked for stand in "out/308-histograms.png".
Status draw_one(const std::string& file, const std::string& title, const FlownStudy& flown) {
  const Status status = draw(file, picture_of(title, flown));
  const bool has_both = !flown.result.over_inputs.empty() && flown.histogram_bars > 0;
  return status && has_both ? draw(beside(file, "histograms"), histograms_picture(title, flown)) : status;
}

/// One picture, and further ones beside it of a study that is told at places, too: "out/308-at-1.png" of the first of
/// them, "out/308-ranges.png" over range.
Status draw_all(const std::string& file, const std::string& title, const FlownStudy& flown) {
  Status status = draw_one(file, title, flown);
  for (std::size_t i = 0; i < flown.at.size() && status; ++i)
    status =
        draw_one(beside(file, "at-" + std::to_string(i + 1)), title + ", at " + name_of_place(flown, i), flown.at[i]);
  const std::vector<StudyAtRange> ranges = ranges_of(flown);
  return status && ranges.size() > 1 ? draw(beside(file, "ranges"), ranges_picture(title, ranges)) : status;
}

/// Announces the pictures that may stand beside the one that was asked for.
Status announce_pictures(const StudyCommand& command, const ScenarioStudy& texts) {
  if (command.plot.empty() || !command.ranges.empty()) return {};
  std::vector<std::string> files = {command.plot};
  for (std::size_t i = 0; i < texts.at.size(); ++i)
    files.push_back(beside(command.plot, "at-" + std::to_string(i + 1)));
  if (texts.over_inputs > 0 && texts.histograms > 0)
    for (std::size_t i = files.size(); i-- > 0;) files.push_back(beside(files[i], "histograms"));
  if (!texts.at.empty()) files.push_back(beside(command.plot, "ranges"));
  for (std::size_t i = 1; i < files.size(); ++i)
    if (Status status = announce(files[i], "--plot"); !status) return status;
  return {};
}

Status write_files(const StudyCommand& command, const AskedShot& asked, const FlownStudy& flown, TaskRunner& threads) {
  if (!command.hdf5.empty())
    if (Status status = write_columns(command.hdf5, title_of_shot(asked), flown.plan, flown.result.shards, threads);
        !status)
      return status;
  if (!command.plot.empty())
    if (Status status = draw_all(command.plot, title_of_shot(asked), flown); !status) return status;
  if (!command.kml.empty()) {
    const auto map = study_kml(asked, flown);
    if (!map) return map.error();
    if (Status status = write_output(command.kml, *map); !status) return status;
  }
  return command.csv.empty() ? Status() : write_output(command.csv, csv_text(records_of(flown)));
}

/// What several ranks do not fly.
Status check_job(const StudyCommand& command, const Ranks& ranks) {
  if (Status status = ranks.status(); !status || ranks.count() == 1) return status;
  if (!command.ranges.empty()) return Error{"ranks of a job fly one study", "--ranges", "give --range"};
  if (!command.shards.empty())
    return Error{"ranks of a job fly all of a study", "--shards", "leave it out; the first rank hands out shards"};
  return {};
}

/// One shot again, such as the worst.
Result<int> fly_again(const StudyCommand& command, const AskedShot& asked, const Study& study) {
  const auto plan = plan_study(study);
  if (!plan) return about_study(command, asked, plan.error());
  const std::uint64_t shots = plan->shards() * study.shard_shots;
  if (*command.fly >= shots)
    return Error{"the study has shots 0 to " + std::to_string(shots - 1), "--fly",
                 "give one of these, or more --shots"};
  return done(give(command.question, study_shot_answer(asked, *plan, *command.fly, style_of(stdout))));
}

/// How often a log is told how far it has come.
Status read_log_seconds(StudyCommand& command) {
  const auto every = option_value("--log-every", command.log_every, Quantity::time);
  if (!every) return every.error();
  if (!*every) return {};
  if (!(**every > 0)) return Error{"must be above 0", "--log-every", "as in \"1 min\" or \"10 s\""};
  command.log_seconds = **every;
  return {};
}

Result<int> run(StudyCommand command) {
  Ranks ranks;
  if (ranks.number() > 0) return serve(command, ranks);
  if (Status status = check_job(command, ranks); !status) return status.error();
  if (Status status = check_command(command); !status) return status.error();
  if (Status status = read_log_seconds(command); !status) return status.error();
  const auto all = ask_study(command);
  if (!all) return all.error();
  const auto& [asked, study] = *all;
  warn_of_curve(asked.scenario, asked.shot());
  warn_of_other_shots(command, asked);
  if (Status status = announce_pictures(command, asked.scenario.study); !status) return status.error();
  if (asked.scenario.world.given) warn_of_things(asked.scenario, "a study of a scenario with a [world]");
  const auto threads = make_thread_pool(command.threads.value_or(0));
  if (command.fly) return fly_again(command, asked, study);
  if (!command.shards.empty()) return run_part(command, asked, study, *threads);
  if (!command.ranges.empty()) return run_over_ranges(command, asked, study, *threads, ranks);
  const auto flown = fly_study(study, asked.scenario.study, *threads, ranks, command);
  if (!flown) return about_study(command, asked, flown.error());
  if (Status status = write_files(command, asked, *flown, *threads); !status) return status.error();
  const bool misses = misses_width(study, flown->result);
  if (misses) warn_of_width();
  const ExitCode code = misses ? kExitCheckMissed : kExitOk;
  if (command.csv == "-" || command.kml == "-") return code;
  return done(give(command.question, study_answer(asked, *flown, style_of(stdout))), code);
}

void add_part_options(Command& command, StudyCommand& options) {
  command.add_output("--resume", options.resume, "FILE",
                     "Keep what is flown in this file, and go on with what it has: a run that dies loses a second",
                     {.replaces = kResumedPart});
  command.add_option("--shards", options.shards, "K/N",
                     "Fly the K-th of N parts alone into the file of --resume, for arrays of jobs");
  command
      .add_option("--merge", options.merge, "FILE",
                  "Join what another run flew; may be given many times. With --resume what is missing is flown, too")
      .one_value_each();
}

void add_file_options(Command& command, StudyCommand& options) {
  command.add_output("--csv", options.csv, "FILE", "Write all figures as CSV; - is the standard output");
  command.add_output(
      "--plot", options.plot, "FILE.png|svg",
      "Draw it: impacts with ellipses and targets, what each input does, how the figure settles; with "
      "--ranges hits over range, with --over-inputs hits over each input, with --histograms these; with --at a picture "
      "of each place beside it");
  command.add_output(
      "--kml", options.kml, "FILE",
      "Write a map of where shots come down, for globes: ellipses, safety zone, shots; - is the standard output");
  command.add_output(
      "--hdf5", options.hdf5, "FILE",
      "Write each shot as columns of an HDF5 file, what it drew, where it ended and what it hit; they are "
      "flown again for it");
}

}  // namespace

void add_study_command(Command& program) {
  Command command =
      program.add_command("study", "Fly a shot with uncertain numbers: hit probability, spread, what matters");
  auto options = std::make_shared<StudyCommand>();
  add_question_options(command, options->question);
  command
      .add_option("--vary", options->vary, "TEXT",
                  "A further uncertain number, as \"shot.speed = 800 m/s +- 3 m/s\"; may be given many times")
      .one_value_each();
  command
      .add_option(
          "--target", options->targets, "TEXT",
          "A further target, as \"circle 10 cm\", \"plate: rectangle 30 cm x 50 cm at 0 m, 1 m\" or \"thing NAME\"")
      .one_value_each();
  command
      .add_option("--at", options->at, "PLACE",
                  "Tell of the same flights on their way, too: \"400 m\", \"apex\", \"height 100 m falling\", with "
                  "other quantities \"apex: y, time\"; may be given many times")
      .one_value_each();
  command.add_option("--range", options->range, "LENGTH", "Where the plane of impact stands, instead of until.range");
  command.add_option("--ranges", options->ranges, "RANGES",
                     "Hit probability over range, as \"100 m .. 1000 m step 100 m\"; a zeroed shot is zeroed at each");
  command.add_option(
      "--over-inputs", options->over_inputs,
      "Hit probability over each input, by so many equally likely parts of it, 2 to 100; --plot draws it");
  command.add_option("--histograms", options->histograms,
                     "A histogram of each quantity, of so many bars, 3 to 1000; --plot draws them");
  command.add_option("--shots", options->shots, "At least so many, instead of study.shots");
  command.add_option("--until-width", options->width, "WIDTH",
                     "Stop when the hit probability of the first target is known to so much, as \"1 %\"; without "
                     "targets, the first quantity's mean, as \"2 mm\"");
  command.add_option("--until-time", options->time, "TIME",
                     "Stop when so much time is up, as \"30 s\" (with --ranges at each), after as many shots as fit; "
                     "how many is printed, and --shots of so many gives the same bits");
  command.add_option("--fly", options->fly,
                     "Fly one shot again by its number, such as the worst: what it drew, where it ended, what it hit");
  command.add_option("--threads", options->threads, "That fly; without it all that the machine has");
  command.add_option("--log-every", options->log_every, "TIME",
                     "How often a log gets a line with rate, time left and the figure so far, instead of 1 min; on a "
                     "terminal they stand below and change");
  add_file_options(command, *options);
  add_part_options(command, *options);
  command.footer(
      "As a job of MPI, `mpirun -n 64 physim study FILE`, all ranks fly one study, one thread each.\n"
      "The same study has the same bits with any number of threads and ranks, and in any parts.\n\n"
      "Examples:\n"
      "  physim study scenarios/study_308.toml\n"
      "  physim study scenarios/308_168gr_g7.toml --range \"600 m\" --vary \"shot.speed = +- 3 m/s\" \\\n"
      "      --vary \"environment.wind.velocity.z = -2 m/s .. 2 m/s\" --target \"rectangle 45 cm x 75 cm\"\n"
      "  physim study scenarios/study_308.toml --shots 1000000000 --resume out/308.part\n");
  command.action([options] { return run(*options); });
}

}  // namespace physim::cli
