// canvoy profile [PROFILE [OBJECT]]: content of the profiles.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "canvoy/formats/profile_json.hpp"
#include "canvoy/formats/sheet/chosen_profile.hpp"
#include "canvoy/tools/argument/profile_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/sheet/profile_text.hpp"

namespace canvoy::tools {

namespace {

struct ProfileOptions {
  std::string profile;
  std::string object;
  std::string reading;
  bool json = false;
};

/// The objects that match a part of a name.
std::vector<const ObjectInfo*> objects_for(const Profile& profile, const std::string& text) {
  std::vector<const ObjectInfo*> found = find_objects(profile, text);
  if (found.empty()) {
    std::vector<std::string> names;
    for (const ObjectInfo* object : profile.objects) names.emplace_back(object->name);
    throw UsageError(fmt::format("'{}' is no object, entry, field or value of {}{}", text,
                                 profile.name, did_you_mean(text, names)));
  }
  return found;
}

/// `6401:2`, or the name of an entry: only that entry of its object.
void print_objects(const Profile& profile, const std::string& text) {
  if (const auto address = find_address(profile, text); address && address->object != nullptr) {
    const EntryInfo* only = address->sub != 0 ? address->entry : nullptr;
    fmt::print("{}", object_details_text(profile, *address->object, only));
    return;
  }
  const std::vector<const ObjectInfo*> found = objects_for(profile, text);
  if (found.size() == 1) {
    fmt::print("{}", object_details_text(profile, *found.front()));
    return;
  }
  for (const ObjectInfo* object : found) fmt::print("{}\n", object_line(*object));
}

int show(const Profile& profile, const ProfileOptions& options) {
  if (options.json) {
    if (!options.object.empty()) throw UsageError("--json writes a profile as a whole");
    formats::write_profile_json(profile, [](const std::string& line) { fmt::print("{}\n", line); });
  } else if (options.object.empty()) {
    fmt::print("{}", profile_text(profile));
  } else {
    print_objects(profile, options.object);
  }
  return exit_done;
}

int show(const ProfileOptions& options) {
  if (options.profile.empty()) {
    if (options.json) throw UsageError("--json needs a profile: canvoy profile 447-3 --json");
    fmt::print("{}", profile_list_text());
    return exit_done;
  }
  const Profile& profile = parse_profile(options.profile);
  if (options.reading.empty()) return show(profile, options);
  const formats::ChosenProfile chosen(profile, parse_reading(profile, options.reading));
  return show(chosen.profile(), options);
}

}  // namespace

void add_profile(Verb& app) {
  const auto options = std::make_shared<ProfileOptions>();
  Verb& command = app.add_verb("profile", "Show what the device profiles say");
  command.add({
      {"profile", options->profile, "419, 447-3; without it, all are listed"},
      {"object", options->object,
       "an index (600D, 6383:1), a name (door_status), or a word of a name"},
      {"--reading", options->reading,
       "where the text contradicts itself: another reading than the usual one"},
      {"--json", options->json, "the whole profile as JSON Lines"},
  });
  command.add_examples(
      "  canvoy profile\n"
      "  canvoy profile 447-3\n"
      "  canvoy profile 407 6489\n"
      "  canvoy profile 419 battery_temperature\n"
      "  canvoy profile 418 --json");
  command.runs([options] { return show(*options); });
}

}  // namespace canvoy::tools
