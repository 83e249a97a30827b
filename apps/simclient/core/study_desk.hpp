// Study desk: what is asked about uncertain shots, and the study that answers it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenario/scenario.hpp"
#include "simclient/core/study_run.hpp"

namespace physim::client {

class Client;

/// What a study is asked, as texts of a scenario, and its run.
struct StudyDesk {
  ScenarioStudy asked;   // begins as that of the scenario
  std::string width;     // ends it when the figure that settles is known to so much, "1 %", "2 mm"; empty: shots do
  std::string shown_at;  // the name of the place that is shown, of those in place_names(); else the end is
  StudyRun run;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> begun_at;  // what Client::versions() were then
};

/// Starts a study of the next shot, pauses it, lets it go on; one that is done starts anew.
[[nodiscard]] Status start_or_pause_study(Client& client);
/// Throws away what was flown, and begins anew with the next shot as it is set now.
[[nodiscard]] Status begin_study(Client& client);
/// A further uncertain number, "shot.speed = +- 3 m/s"; a text alone that has one already takes its place. What was
/// flown is of another study then, and is forgotten.
[[nodiscard]] Status add_study_input(Client& client, const std::string& text);
/// A further target, "plate: rectangle 45 cm x 75 cm".
[[nodiscard]] Status add_study_target(Client& client, const std::string& text);
/// A further place that the same flights are told at, "apex: y, time"; one that is there already takes the new text.
[[nodiscard]] Status add_study_at(Client& client, const std::string& text);
/// Takes a text out again: an input, a target or a place.
void remove_study_text(Client& client, std::vector<std::string> ScenarioStudy::*list, std::size_t text);
[[nodiscard]] Status set_study_shots(Client& client, const std::string& text);
/// "1 %", "2 mm"; empty: as many shots as are asked for.
[[nodiscard]] Status set_study_width(Client& client, const std::string& text);

/// What places are called, in the order of `asked.at`: "500 m", "apex".
[[nodiscard]] std::vector<std::string> place_names(const StudyDesk& desk);
/// Shows the study at a place, named as above or as it was asked for; "end": where it ends.
[[nodiscard]] Status show_study_at(Client& client, const std::string& place);
/// Which of `asked.at` is shown; nothing: the end.
[[nodiscard]] std::optional<std::size_t> shown_place(const StudyDesk& desk);

}  // namespace physim::client
