#include <array>

#include "canvoy/tools/page/api_routes.hpp"
#include "canvoy/tools/page/playback.hpp"

namespace canvoy::tools {

namespace {

constexpr double whole_most = 0x1p53;  ///< below it, each integer is a double
constexpr double seconds_most = 1e9;
constexpr double faults_most = 200;
constexpr double acts_most = 10'000;
constexpr double node_most = 127;
constexpr double floor_most = 254;

constexpr ApiMember bus{
    .name = "bus", .place = ApiPlace::path, .description = "name of a network: lift1, sim0, can0"};
constexpr ApiMember node{.name = "node",
                         .place = ApiPlace::path,
                         .kind = ApiKind::integer,
                         .description = "node-ID",
                         .least = 1,
                         .most = node_most};
constexpr ApiMember node_or_all{.name = "node",
                                .place = ApiPlace::path,
                                .kind = ApiKind::integer,
                                .description = "node-ID; 0: all",
                                .most = node_most};
constexpr ApiMember object{
    .name = "object",
    .place = ApiPlace::path,
    .description = "1017, 1018:4, or the name that the profile gives it: battery_temperature"};

constexpr std::array since_members = {ApiMember{.name = "since",
                                                .place = ApiPlace::query,
                                                .kind = ApiKind::integer,
                                                .description = "next of an answer before",
                                                .most = whole_most,
                                                .is_required = false}};
constexpr std::array objects_members = {bus, node_or_all,
                                        ApiMember{.name = "search",
                                                  .place = ApiPlace::query,
                                                  .description = "in a name or index",
                                                  .is_required = false}};
constexpr std::array trend_members = {
    ApiMember{.name = "names",
              .place = ApiPlace::query,
              .description = "places in a snapshot: plant.current_a,lifts.0.position_m"}};
constexpr std::array read_members = {bus, node, object};
constexpr std::array history_members = {bus, node_or_all, object};
constexpr std::array write_members = {
    bus, node, object,
    ApiMember{.name = "value",
              .description = "as canvoy write takes it: 21.5, '48 V', ready, hex:01 02"}};
constexpr std::array<std::string_view, 5> commands = {"start", "stop", "enter pre-operational",
                                                      "reset node", "reset communication"};
constexpr std::array nmt_members = {bus, node_or_all,
                                    ApiMember{.name = "command", .choices = commands}};
constexpr std::array pause_members = {ApiMember{.name = "paused",
                                                .kind = ApiKind::truth,
                                                .description = "or not",
                                                .is_required = false,
                                                .is_true = true}};
constexpr std::array speed_members = {ApiMember{
    .name = "speed", .kind = ApiKind::number, .description = "times", .most = Playback::speed_max}};
constexpr std::array step_members = {ApiMember{.name = "step_s",
                                               .kind = ApiKind::number,
                                               .description = "seconds, an hour is done at most",
                                               .most = seconds_most}};
constexpr std::array seek_members = {ApiMember{
    .name = "time", .kind = ApiKind::number, .description = "seconds", .most = seconds_most}};
constexpr std::array fault_members = {
    ApiMember{.name = "fault", .description = "kind and place: lost-node:node=5"},
    ApiMember{.name = "duration_s",
              .kind = ApiKind::number,
              .description = "seconds; 0: for the rest",
              .most = seconds_most}};
constexpr std::array visit_members = {ApiMember{.name = "from",
                                                .kind = ApiKind::integer,
                                                .description = "floor",
                                                .least = 1,
                                                .most = floor_most},
                                      ApiMember{.name = "to",
                                                .kind = ApiKind::integer,
                                                .description = "floor",
                                                .least = 1,
                                                .most = floor_most}};
constexpr std::array restart_members = {
    ApiMember{.name = "seed", .kind = ApiKind::integer, .most = whole_most, .is_required = false},
    ApiMember{.name = "faults",
              .kind = ApiKind::texts,
              .description = "as --fault of canvoy run has them",
              .most = faults_most,
              .is_required = false},
    ApiMember{.name = "acts",
              .kind = ApiKind::texts,
              .description = "as --act of canvoy run has them",
              .most = acts_most,
              .is_required = false},
    ApiMember{.name = "keep",
              .kind = ApiKind::truth,
              .description = "up to the time where it is",
              .is_required = false}};
constexpr std::array record_members = {ApiMember{.name = "on",
                                                 .kind = ApiKind::truth,
                                                 .description = "or not",
                                                 .is_required = false,
                                                 .is_true = true}};

constexpr std::array not_there = {404U};
constexpr std::array not_now = {409U};
constexpr std::array of_node = {404U, 502U, 504U};
constexpr std::array of_value = {404U, 422U, 502U, 504U};
constexpr std::array of_command = {404U, 502U};
constexpr std::array of_words = {422U, 502U};
constexpr std::array of_run = {502U};

constexpr std::array routes = {
    ApiRoute{.method = "GET",
             .path = "/api",
             .name = "description",
             .summary = "What is looked at, and what may be done",
             .action = ApiAction::description,
             .answer = "Description"},
    ApiRoute{.method = "GET",
             .path = "/api/state",
             .name = "state",
             .summary = "As it is now: as canvoy run --json has snapshot and summary, with counts "
                        "of frames",
             .action = ApiAction::state,
             .answer = "State"},
    ApiRoute{.method = "GET",
             .path = "/api/networks",
             .name = "networks",
             .summary = "Networks that were heard",
             .action = ApiAction::networks,
             .answer = "Networks"},
    ApiRoute{.method = "GET",
             .path = "/api/nodes",
             .name = "nodes",
             .summary = "Nodes, with their states",
             .action = ApiAction::nodes,
             .answer = "Nodes"},
    ApiRoute{.method = "GET",
             .path = "/api/values",
             .name = "values",
             .summary = "The latest value of each object that was heard",
             .action = ApiAction::values,
             .answer = "Values"},
    ApiRoute{.method = "GET",
             .path = "/api/events",
             .name = "events",
             .summary = "What has happened",
             .action = ApiAction::events,
             .members = since_members,
             .answer = "Events"},
    ApiRoute{.method = "GET",
             .path = "/api/frames.log",
             .name = "frames",
             .summary = "The latest frames, at most 200,000, as a candump log",
             .action = ApiAction::frames,
             .type = "text/plain"},
    ApiRoute{
        .method = "GET",
        .path = "/api/run.toml",
        .name = "runFile",
        .summary =
            "The run as it is played, with its seed, its faults and what was done: a network file "
            "that `canvoy run FILE` plays the same",
        .action = ApiAction::run_file,
        .type = "application/toml",
        .statuses = not_there},
    ApiRoute{.method = "GET",
             .path = "/api/run/trend",
             .name = "trend",
             .summary = "Numbers of the snapshot from the start until now, at most 600 of each",
             .members = trend_members,
             .answer = "Trend",
             .statuses = not_now},
    ApiRoute{.method = "GET",
             .path = "/api/networks/{bus}/nodes/{node}/objects",
             .name = "objects",
             .summary = "Objects of the node's profile, at most 300",
             .members = objects_members,
             .answer = "Objects",
             .statuses = not_there},
    ApiRoute{
        .method = "GET",
        .path = "/api/networks/{bus}/nodes/{node}/objects/{object}/history",
        .name = "history",
        .summary = "The value as it was heard from the start until now, thinned to 1000 samples",
        .members = history_members,
        .answer = "History",
        .statuses = not_there},
    ApiRoute{.method = "POST",
             .path = "/api/networks/{bus}/nodes/{node}/objects/{object}",
             .name = "write",
             .summary = "Write by SDO, where --allow-write has it",
             .members = write_members,
             .answer = "Written",
             .statuses = of_value},
    ApiRoute{.method = "POST",
             .path = "/api/networks/{bus}/nodes/{node}/objects/{object}/read",
             .name = "read",
             .summary = "Read by SDO: it sends frames. As canvoy read --json",
             .members = read_members,
             .answer = "Value",
             .statuses = of_node},
    ApiRoute{.method = "POST",
             .path = "/api/networks/{bus}/nodes/{node}/nmt",
             .name = "nmt",
             .summary = "An NMT command, where --allow-write has nmt",
             .members = nmt_members,
             .answer = "Sent",
             .statuses = of_command},
    ApiRoute{.method = "POST",
             .path = "/api/run/pause",
             .name = "pause",
             .summary = "Pause a run, or let it go on",
             .members = pause_members,
             .answer = "Done",
             .statuses = of_run},
    ApiRoute{.method = "POST",
             .path = "/api/run/speed",
             .name = "speed",
             .summary = "Play so many times faster than the clock",
             .members = speed_members,
             .answer = "Done",
             .statuses = of_run},
    ApiRoute{.method = "POST",
             .path = "/api/run/step",
             .name = "step",
             .summary = "Play so much further, and pause",
             .members = step_members,
             .answer = "Done",
             .statuses = of_run},
    ApiRoute{.method = "POST",
             .path = "/api/run/seek",
             .name = "seek",
             .summary = "Go to a time of the run; back: it is played from its start up to there",
             .members = seek_members,
             .answer = "Done",
             .statuses = of_run},
    ApiRoute{.method = "POST",
             .path = "/api/run/fault",
             .name = "fault",
             .summary = "A fault begins now; the run is played from its start once more",
             .members = fault_members,
             .answer = "Done",
             .statuses = of_words},
    ApiRoute{.method = "POST",
             .path = "/api/run/visit",
             .name = "visit",
             .summary = "Somebody comes to a lift",
             .members = visit_members,
             .answer = "Done",
             .statuses = of_words},
    ApiRoute{.method = "POST",
             .path = "/api/run/restart",
             .name = "restart",
             .summary = "Another run: from the start, with this seed, these faults and acts",
             .members = restart_members,
             .answer = "Done",
             .statuses = of_words},
    ApiRoute{.method = "POST",
             .path = "/api/run/record",
             .name = "record",
             .summary = "Begin a log of all frames in the folder of --allow-record, or end it",
             .members = record_members,
             .answer = "Done",
             .statuses = of_run},
};

}  // namespace

std::span<const ApiRoute> api_routes() {
  return routes;
}

}  // namespace canvoy::tools
