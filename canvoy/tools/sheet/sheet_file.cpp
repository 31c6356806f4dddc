#include "canvoy/tools/sheet/sheet_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/xdd/xdd.hpp"
#include "canvoy/formats/xdd/xdd_writer.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/meant_line.hpp"
#include "canvoy/tools/cli/value_file.hpp"

namespace canvoy::tools {

namespace {

/// Reason why a file is no data sheet of a device: where, and what to do.
std::string without_objects(const std::string& path, const formats::DataSheet& sheet,
                            const formats::Findings& findings) {
  const bool is_sheet =
      sheet.section("FileInfo") != nullptr || sheet.section("DeviceInfo") != nullptr;
  if (is_sheet) {
    return fmt::format(
        "{}: it is a template without objects: describe those of the device, as [1000] with "
        "ParameterName, ObjectType, DataType and AccessType, and list them in [MandatoryObjects]",
        path);
  }
  const auto first =
      std::ranges::find(findings, formats::Finding::Weight::error, &formats::Finding::weight);
  if (first != findings.end()) {
    return finding_text(path, *first) + ": is it an EDS, DCF, XDD or XDC?";
  }
  return fmt::format("{}: no object is described here: is it an EDS, DCF, XDD or XDC?", path);
}

}  // namespace

formats::DataSheet parse_sheet_text(std::string_view text, formats::Findings& findings) {
  return formats::is_xml(text) ? formats::read_xdd(text, findings)
                               : formats::read_eds(text, findings);
}

formats::DataSheet read_sheet_file(const std::string& path, formats::Findings& findings) {
  const std::vector<std::uint8_t> bytes = read_value_file(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  formats::DataSheet sheet = parse_sheet_text(text, findings);
  if (!sheet.objects.empty()) return sheet;
  throw Failure(without_objects(path, sheet, findings));
}

std::string sheet_text(const formats::DataSheet& sheet, const std::string& path) {
  const std::string_view name = path;
  const auto ends_with = [name](std::string_view ending) {
    return name.size() > ending.size() &&
           formats::same_letters(name.substr(name.size() - ending.size()), ending);
  };
  formats::DataSheet written = sheet;
  written.configured = sheet.configured && !ends_with(".eds") && !ends_with(".xdd");
  if (ends_with(".xdd") || ends_with(".xdc")) return formats::write_xdd(written);
  if (ends_with(".eds") || ends_with(".dcf")) return formats::write_eds(written);
  throw UsageError(fmt::format("{}: name it .eds, .dcf, .xdd or .xdc", path));
}

void require_values(const std::string& path, std::vector<std::string> line) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".dcf" || ending == ".xdc") return;
  const bool is_eds = formats::same_letters(ending, ".eds");
  if (!is_eds && !formats::same_letters(ending, ".xdd")) {
    throw UsageError(fmt::format("{}: name it .dcf or .xdc", path));
  }
  const std::string with_values = new_file(path, is_eds ? "dcf" : "xdc");
  line.insert(line.end(), {"--out", with_values});
  throw UsageError(fmt::format(
      "{}: an {} holds no values, and those of a node are read: {}; {} leaves them out", path,
      is_eds ? "EDS" : "XDD", typed_line(line), typed_line({"eds", "convert", with_values, path})));
}

std::string finding_text(const std::string& path, const formats::Finding& finding) {
  std::string text = path + ':';
  if (finding.line != 0) text += fmt::format("{}:", finding.line);
  // The following text contains words of the file.
  const std::size_t own = text.size();
  if (!finding.section.empty()) text += fmt::format(" [{}]", finding.section);
  if (finding.weight == formats::Finding::Weight::warning) text += " warning:";
  text += ' ' + finding.text;
  if (!finding.expected.empty()) text += "; expected: " + finding.expected;
  return text.substr(0, own) + formats::plain_text(text.substr(own));
}

}  // namespace canvoy::tools
