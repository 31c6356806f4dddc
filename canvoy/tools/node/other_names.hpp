// Lines as other programs have them: their names of verbs, with the options of those programs, and
// an order with the bus in front. Where one line can be meant, it is made; else it is told.
//
//     put_verb_in_front(words);  // can0 10 read 1018 as read can0 10 1018
//     use_own_names(words);     // candump -ta can0 as monitor can0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// A verb of the command line, and what others call it.
struct VerbWords {
  std::string_view name;
  std::string_view others = {};  ///< names that mean this verb alone, separated by blanks
  std::string_view told = {};    ///< names that may mean others as well: the line is told, not run
};
inline constexpr auto verb_words = std::to_array<VerbWords>({
    {"run", "", "simulate sim emulate"},
    {"device"},
    {"monitor", "dump listen sniff watch logs frames trace spy follow traffic tail"},
    {"view", "open serve web"},
    {"report"},
    {"decode", "cat head parse print dekodieren"},
    {"convert-log", "convert logconvert log-convert umwandeln konvertieren"},
    {"record", "capture aufzeichnen", "log"},
    {"replay", "play abspielen"},
    {"stats", "summary summarize statistics statistik"},
    {"doctor", "analyze analyse diagnose"},
    {"check", "", "test"},
    {"load"},
    {"explain", "lookup error abort errno what whatis describe define"},
    {"search", "find suchen"},
    {"program", "flash"},
    {"boot"},
    {"gateway"},
    {"lss"},
    {"profile"},
    {"eds"},
    {"eds check", "validate lint verify", "info show"},
    {"eds diff", "diff compare"},
    {"export"},
    {"export dbc", "dbc"},
    {"scan", "list find-nodes identify ls ps who detect nodes ping status discover"},
    {"clone"},
    {"plot", "graph chart curve curves draw"},
    {"browse", "od objects dictionary"},
    {"read", "get upload r request query peek lesen", "sdo"},
    {"write", "set w poke schreiben", "download"},
    {"nmt", "start reset"},
    {"configure", "config apply load-dcf"},
    {"store"},
    {"restore", "factory-reset defaults"},
    {"send", "cansend"},
    {"sync"},
    {"time"},
    {"emcy"},
    {"pdo"},
    {"expect"},
    {"wait"},
    {"script"},
    {"completion"},
});

/// True for the name of a verb of the command line.
bool is_verb_name(std::string_view word);
/// True for a file name of a data sheet: EDS, DCF, XDD, XDC.
bool is_sheet_name(std::string_view word);

/// True if the verb is found behind the buses, nodes and options without a value in front of it.
bool finds_verb(const std::vector<std::string>& words);
/// The words from this place on, with our name of the verb there, `cat a.log` as `decode a.log`, or
/// the verb of a thing that stands alone, `a.log`; empty: it is neither.
std::vector<std::string> line_from(const std::vector<std::string>& words, std::size_t at);

/// The verb goes to the front; bus and node behind it, also those of `--bus can0` before the verb.
/// Throws UsageError for a bus alone.
void put_verb_in_front(std::vector<std::string>& words);

/// Our name of the verb, and our options. Throws UsageError with the intended line.
void use_own_names(std::vector<std::string>& words);

}  // namespace canvoy::tools
