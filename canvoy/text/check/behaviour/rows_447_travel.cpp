// Virtual devices of a car (CiA 447-3): GPS receiver, navigation system, driver identification, and
// the sound of a roof bar.
#include "canvoy/profiles/cia447.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"

namespace canvoy::conformance {

namespace of_447_travel {
namespace {

namespace car = cia447;

/// Time to take effect; no clause gives one.
constexpr Duration takes_effect = 5s;
/// Time of a receiver that starts without an almanac.
constexpr Duration first_fix = 15min;
constexpr Duration card_is_seen = 100ms;
constexpr std::uint64_t lowest_two = 0x03;

// GPS (CiA 447-3, 4.2.10): the fix in bits 27 to 24; the bits above are reserved, and 1.

constexpr Place gps_latitude{&car::gps_current_position_object, 1};
constexpr Place gps_status{&car::gps_status_object, 0};
constexpr Place gps_date{&car::gps_date_object, 0};
constexpr std::uint64_t fix = 0x0F00'0000;
constexpr std::int64_t no_fix = 0x0000'0000;
constexpr std::int64_t fix_3d = 0x0200'0000;
constexpr std::string_view cover = "cover the antenna of the GPS receiver";
constexpr std::string_view uncover = "give the GPS receiver a view of the whole sky";

constexpr BehaviourRow gps_rows[] = {
    row("447-3-gps-01", "4.2.10.3",
        "a receiver with a view of the sky has a fix, and one without has none",
        {hand(uncover), is(gps_status, fix_3d, fix, first_fix), hand(cover),
         is(gps_status, no_fix, fix, takes_effect), hand(uncover),
         is(gps_status, fix_3d, fix, first_fix)}),
    row("447-3-gps-02", "4.2.10.1", "a position that becomes known is told",
        {hand(cover), is(gps_status, no_fix, fix, takes_effect), start, hand(uncover),
         tells_any(gps_latitude, first_fix)}),
    row("447-3-gps-03", "4.2.10.3", "reserved bits of the status are 1",
        {is(gps_status, 0xF000'0000, 0xF000'0000)}),
    row("447-3-gps-04", "4.2.10.4", "reserved bits of the date are 1",
        {is(gps_date, 0xFC00'0000, 0xFC00'0000)}),
    row("447-3-gps-05", "4.2.10.1", "nobody writes where a receiver is",
        {refuse(gps_latitude, 0x1CB1'A3E8)}, {gps_status}),
};

// Navigation system (CiA 447-3, 4.2.11). A position is in 0,0000001 degrees, with south and west as
// codes above north and east; FFFF FFFFh is "do not care".

constexpr Place distance{&car::distance_to_selected_destination_object, 0};
constexpr Place asked_latitude{&car::position_description_request_object, 1};
constexpr Place asked_longitude{&car::position_description_request_object, 2};
constexpr Place to_latitude{&car::start_route_guidance_object, 1};
constexpr Place to_longitude{&car::start_route_guidance_object, 2};
constexpr Place guidance{&car::start_route_guidance_object, 3};
constexpr Place here_latitude{&car::gps_current_position_object, 1};
constexpr Place here_longitude{&car::gps_current_position_object, 2};
constexpr Place asked_where{&car::current_position_request_object, 0};
constexpr std::int64_t munich_latitude = 481'370'000;
constexpr std::int64_t munich_longitude = 115'750'000;
/// A tenth of a degree to the north: 11.1 km away.
constexpr std::int64_t north_of_munich = munich_latitude + 1'000'000;
/// 25.5 km, in 0.1 km.
constexpr std::uint64_t beyond_near = 0xFF00;
constexpr std::int64_t no_destination = 0xFFFD;
constexpr std::int64_t beyond_latitude = 0x6B49'D201;
constexpr std::int64_t beyond_longitude = 0xD693'A401;
constexpr Step cancels = hand("select no destination at the navigation system");
constexpr Step is_in_munich_n = put(here_latitude, munich_latitude);
constexpr Step is_in_munich_e = put(here_longitude, munich_longitude);

constexpr BehaviourRow navigation_rows[] = {
    row("447-3-navigation-01", "4.2.11.1", "without a destination the distance says so",
        {cancels, is(distance, no_destination, 0xFFFF, takes_effect)}),
    row("447-3-navigation-02", "4.2.11.4", "guidance that is started has a distance",
        {cancels, is_in_munich_n, is_in_munich_e, put(to_latitude, north_of_munich),
         put(to_longitude, munich_longitude), put(guidance, 0x01),
         is(distance, 0, beyond_near, takes_effect), cancels}),
    row("447-3-navigation-03", "4.2.11.4",
        "guidance is started without interrupting where there is none",
        {cancels, is_in_munich_n, is_in_munich_e, put(to_latitude, north_of_munich),
         put(to_longitude, munich_longitude), put(guidance, 0x00),
         is(distance, 0, beyond_near, takes_effect), cancels}),
    row("447-3-navigation-04", "4.2.11.4",
        "a position alone starts no guidance, nor does \"do not care\"",
        {cancels, put(to_latitude, north_of_munich), put(to_longitude, munich_longitude),
         put(guidance, 0xFF), stays(distance, no_destination, 0xFFFF, 2s)}),
    row("447-3-navigation-05", "4.2.11.4", "a reserved start is refused",
        {refuse(guidance, 0x02), refuse(guidance, 0xFE)}),
    row("447-3-navigation-06", "4.2.11.4", "a destination that is nowhere is refused",
        {refuse(to_latitude, beyond_latitude), refuse(to_longitude, beyond_longitude)}),
    row("447-3-navigation-07", "4.2.11.2", "a position that is nowhere is not described",
        {refuse(asked_latitude, beyond_latitude), refuse(asked_longitude, beyond_longitude)}),
    row("447-3-navigation-08", "4.2.11.5", "the position in words is asked for",
        {put(asked_where, 0xFE), put(asked_where, 0xFF)}),
};

// Driver identification (CiA 447-3, 4.2.15).

constexpr Place driver_status{&car::driver_id_status_object, 0};
constexpr Place driver_id{&car::unique_driver_id_object, 0};
constexpr std::uint64_t identification_failure = 0x30;
constexpr std::string_view card_in = "log a driver in";
constexpr std::string_view card_out = "log the driver out";
constexpr std::string_view strange_card = "show a card that is not known to the reader";

constexpr BehaviourRow driver_rows[] = {
    row("447-3-driver-01", "4.2.15.2", "a driver is logged in and out",
        {hand(card_out), is(driver_status, 0, lowest_two), hand(card_in),
         is(driver_status, 1, lowest_two), hand(card_out), is(driver_status, 0, lowest_two)}),
    row("447-3-driver-02", "4.2.15.2",
        "a driver who is logged in is told, and when he is logged out",
        {hand(card_out), start, wait(card_is_seen), hand(card_in),
         tells(driver_status, 1, lowest_two), hand(card_out), tells(driver_status, 0, lowest_two)}),
    row("447-3-driver-03", "4.2.15.2", "data of a driver who is logged in are valid",
        {hand(card_out), hand(card_in), is(driver_status, 0x04, 0x0C), hand(card_out)}),
    row("447-3-driver-04", "4.2.15.2",
        "a card that is not known is an identification failure, and logs nobody in",
        {hand(card_out), hand(strange_card), is(driver_status, 0x10, identification_failure),
         is(driver_status, 0, lowest_two), hand(card_in),
         is(driver_status, 0, identification_failure), hand(card_out)}),
    row("447-3-driver-05", "4.2.15.2", "reserved bits of the status are 1",
        {is(driver_status, 0xC0, 0xC0)}),
    row("447-3-driver-06", "4.2.15.1", "nobody writes who drives",
        {refuse(driver_status, 0xC5), refuse(driver_id, 4711)}),
};

// Sound of a roof bar (CiA 447-3, 4.2.21). Command 1: the additional sound in bits 7 to 0, its
// speed in 9 and 8, city or land in 17 and 16, the volume in 29 to 24; all ones of a field are "do
// not care".

constexpr Place country_command{&car::country_specific_sound_command_object, 0};
constexpr Place country_status{&car::country_specific_sound_status_object, 0};
constexpr Place sound_command{&car::sound_command_roof_bar_object, 1};
constexpr Place sound_status{&car::sound_status_roof_bar_object, 1};
constexpr Place audio_command{&car::sound_command_roof_bar_object, 2};
constexpr Place audio_status{&car::sound_status_roof_bar_object, 2};
constexpr std::uint64_t sound = 0xFF;
constexpr std::uint64_t volume = 0x3F00'0000;
constexpr Step quiet = put(sound_command, 0xFFFF'FF00);
constexpr Step plays_nothing = is(sound_status, 0x00, sound, takes_effect);
constexpr Step wail = put(sound_command, 0xFFFF'FF06);
constexpr Step wails = is(sound_status, 0x06, sound, takes_effect);

constexpr BehaviourRow sound_rows[] = {
    row("447-3-sound-01", "4.2.21.1", "the sound of a country is selected, and none",
        {put(country_command, 0x00), is(country_status, 0x00, sound, takes_effect),
         put(country_command, 0x01), is(country_status, 0x01, sound, takes_effect),
         put(country_command, 0x00), is(country_status, 0x00, sound, takes_effect)}),
    row("447-3-sound-02", "4.2.21.1", "a sound of a country that is reserved is refused",
        {refuse(country_command, 0x17), refuse(country_command, 0xFE)}),
    row("447-3-sound-03", "4.2.21.3", "an additional sound is turned on and off",
        {quiet, plays_nothing, wail, wails, quiet, plays_nothing}),
    row("447-3-sound-04", "4.2.21.3", "an additional sound that is reserved is refused",
        {quiet, plays_nothing, refuse(sound_command, 0xFFFF'FF09),
         refuse(sound_command, 0xFFFF'FFFE), plays_nothing}),
    row("447-3-sound-05", "4.2.21.3", "\"do not care\" leaves a sound as it is",
        {wail, wails, put(sound_command, 0xFFFF'FFFF), stays(sound_status, 0x06, sound, 1s),
         quiet}),
    row("447-3-sound-06", "4.2.21.3", "a volume is taken",
        {put(sound_command, 0xD0FF'FFFF), is(sound_status, 0x1000'0000, volume, takes_effect),
         put(sound_command, 0xC5FF'FFFF), is(sound_status, 0x0500'0000, volume, takes_effect)}),
    row("447-3-sound-07", "4.2.21.3", "a reserved speed, and a reserved place, are refused",
        {refuse(sound_command, 0xFFFF'FEFF), refuse(sound_command, 0xFFFE'FFFF)}),
    row("447-3-sound-08", "4.2.21.3", "audio is turned on and off",
        {put(audio_command, 0xFFFF'FFFC), is(audio_status, 0, lowest_two, takes_effect),
         put(audio_command, 0xFFFF'FFFD), is(audio_status, 1, lowest_two, takes_effect),
         put(audio_command, 0xFFFF'FFFC), is(audio_status, 0, lowest_two, takes_effect)}),
    row("447-3-sound-09", "4.2.21.4", "reserved bits of the status are 1",
        {is(audio_status, 0xFFFF'FFC0, 0xFFFF'FFC0)}),
    row("447-3-sound-10", "4.2.21.4", "a sound that is turned on is told",
        {start, quiet, plays_nothing, wail, tells(sound_status, 0x06, sound, takes_effect), quiet}),
};

}  // namespace
}  // namespace of_447_travel

std::vector<std::span<const BehaviourRow>> rows_of_447_travel() {
  using namespace of_447_travel;  // NOLINT(google-build-using-namespace): its tables
  return {gps_rows, navigation_rows, driver_rows, sound_rows};
}

}  // namespace canvoy::conformance
