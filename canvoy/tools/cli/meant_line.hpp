// The line that was meant, in the message of one that is refused.
//
//     typed_line({"read", "can0", "10", "a b"});  // canvoy read can0 10 'a b'
//     completed_line({"configure", "can0", "10"}, "configure", examples);
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// A line as one types it: the words behind `canvoy`, in quotes where a shell needs them.
std::string typed_line(const std::vector<std::string>& words);

/// The first line of `examples` with this word, `--table`; empty: none has it.
std::string example_with(std::string_view examples, std::string_view word);

/// The line with what is missing, as the first example of the verb has it; empty where that has no
/// more words.
std::string completed_line(const std::vector<std::string>& words, std::string_view verb,
                           std::string_view examples);

/// True if the line changes neither a node nor a file: it may be told with less words than were
/// typed.
bool only_shows(const std::vector<std::string>& words);

/// True if a line that completes `words` sends no value of an example, and names no file that is
/// there already as one to be written.
bool is_safe_line(std::string_view line, const std::vector<std::string>& words);

/// A file of a told line, which is not there yet: typing it overwrites nothing. `night.log` with
/// the ending `csv` is `night.csv`, or `night-2.csv`.
std::string new_file(std::string_view file, std::string_view ending);

/// The line without these words, each of them once.
std::string line_without(std::vector<std::string> words, const std::vector<std::string>& unknown);

}  // namespace canvoy::tools
