#pragma once
// The pages of docs/tables: one row a page. Each shows the columns of a list that a reader needs.
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gbl {

struct DocsPage {
  const char* list;  // as in `list WHAT`, and the file's name
  const char* title;
  const char* words;                      // below the title
  std::vector<std::string_view> columns;  // in this order
};
std::span<const DocsPage> docs_pages();
std::string docs_text(const DocsPage&);
void write_docs(const std::filesystem::path& folder);  // all of them, as WHAT.md

}  // namespace gbl
