// The files of the page, as they were built from canvoy/web/page; they are a part of the program.
//
//     const PageFile* file = find_page_file("/");
#pragma once

#include <span>
#include <string_view>

namespace canvoy::web {

struct PageFile {
  std::string_view path;  ///< `/page.js`
  std::string_view type;
  std::string_view content;
  std::string_view gzip{};  ///< the same, compressed
  std::string_view tag{};   ///< another one for each content, as ETag has it
};

/// Compressed at the first call.
std::span<const PageFile> page_files();
/// `/` is the page itself; null where there is no such file.
const PageFile* find_page_file(std::string_view path);

/// What a report is made of: `page` has marks where the others, and what is reported, belong.
struct ReportFiles {
  std::string_view page;    ///< with /*style*/, /*report*/ and /*script*/
  std::string_view style;   ///< that of the live page
  std::string_view script;  ///< draws what stands at /*report*/
};
ReportFiles report_files();

}  // namespace canvoy::web
