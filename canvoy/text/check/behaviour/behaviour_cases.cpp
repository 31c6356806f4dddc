#include "canvoy/text/check/behaviour/behaviour_cases.hpp"

#include <fmt/format.h>

#include "canvoy/text/check/behaviour/stage.hpp"

namespace canvoy::conformance {

namespace {

/// `9.2` of CiA 852 becomes `CiA 852, 9.2`; a text with a name is kept.
std::string clause_text(const Profile& profile, std::string_view clause) {
  if (clause.starts_with("CiA ")) return std::string(clause);
  return fmt::format("{}, {}", profile.name, clause);
}

void add_table(TestCases& cases, const Profile& profile, std::span<const BehaviourRow> rows) {
  for (const BehaviourRow& row : rows) {
    cases.push_back({std::string(row.id), Group::behaviour, clause_text(profile, row.clause),
                     std::string(row.title), sends_text(row), expects_text(row),
                     [&row](Bench& bench) { return play(bench, row); }});
  }
}

void add_tables(TestCases& cases, const Profile& profile,
                const std::vector<std::span<const BehaviourRow>>& tables) {
  for (const std::span<const BehaviourRow> rows : tables) add_table(cases, profile, rows);
}

}  // namespace

void add_behaviour_cases(TestCases& cases, const Profile& profile) {
  switch (profile.number) {
    case 401:
      add_table(cases, profile, rows_of_401_outputs());
      return add_table(cases, profile, rows_of_401_inputs());
    case 407:
      add_tables(cases, profile, rows_of_407());
      add_tables(cases, profile, rows_of_407_passengers());
      add_counting_cases(cases);
      return add_event_cases(cases);
    case 417:
      add_tables(cases, profile, rows_of_417());
      add_tables(cases, profile, rows_of_417_controllers());
      return add_panel_cases(cases);
    case 447:
      add_tables(cases, profile, rows_of_447());
      return add_tables(cases, profile, rows_of_447_travel());
    case 419:
      return add_charger_cases(cases);
    case 852:
      add_table(cases, profile, rows_of_401_outputs());
      return add_table(cases, profile, rows_of_852());
    default:
      return;
  }
}

}  // namespace canvoy::conformance
