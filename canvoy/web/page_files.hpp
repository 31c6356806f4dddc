// The files of the page, built from canvoy/web/page and part of the program.
//
//     const PageFile* file = find_page_file("/");
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace canvoy::web {

struct PageFile {
  std::string_view path;  ///< `/page.js`
  std::string_view type;
  std::string_view content;
  std::string_view gzip{};  ///< the file, compressed
  std::string_view tag{};   ///< different for each content, for ETag
};

/// The files; compressed at the first call.
std::span<const PageFile> page_files();
/// The file at a path; `/` is the page itself; null if there is none.
const PageFile* find_page_file(std::string_view path);

/// The files of a report: `page` has marks for the others, and for the content.
struct ReportFiles {
  std::string_view page;    ///< with /*style*/, <!--report--> and <!--pictures-->
  std::string_view style;   ///< rules of the live page's style for what a report shows
  std::string_view script;  ///< draws images from the element `data` in the element `picture`
};
ReportFiles report_files();

/// Compresses with gzip (RFC 1952); the result is reproducible.
std::string compressed(std::string_view text);

}  // namespace canvoy::web
