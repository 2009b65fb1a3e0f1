#include "renderer/study/page/page.h"

#include <fmt/format.h>

#include "renderer/base/json.h"
#include "renderer/base/resources.h"
#include "renderer/study/page/html_text.h"

namespace gbl {
namespace {

// What the script compares side by side; all else it reads off the page.
Json details_json(const Page& page) {
  Json rows = Json::array();
  for (const PageRow& row : page.rows) rows.push_back(row.details);
  return {{"names", page.details}, {"rows", rows}};
}

std::string machine(const Page& page) {
  std::string text = "<footer><h2>Measured with</h2><dl>\n";
  for (const auto& [name, value] : page.machine)
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", html_text(name), html_text(value));
  return text + "</dl></footer>\n";
}

// Nothing may be fetched: what is not in the page is not shown.
constexpr const char* kHead =
    "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
    "'unsafe-inline'; script-src 'unsafe-inline'\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<meta name=\"color-scheme\" content=\"light dark\">\n";

}  // namespace

std::string page_html(const Page& page) {
  std::string text = kHead;
  text += fmt::format("<title>{}</title>\n<style>\n{}</style></head>\n<body>\n", html_text(page.title),
                      resource("assets/page/study.css"));
  text += fmt::format(
      "<header><h1>{}</h1><p>{}</p><p class=\"js\">Point at a dot, or press Tab and the arrow keys. Enter takes "
      "a dot into the comparison, Esc closes its words.</p></header>\n<main>\n",
      html_text(page.title), html_text(page.how_to_read));
  for (size_t i = 0; i < page.charts.size(); ++i) text += page_svg(page.charts[i], i);
  text += "<section id=\"compared\" class=\"js\" hidden><h2>Compared</h2><div class=\"wide\"></div></section>\n";
  text += page_table(page) + "</main>\n" + machine(page);
  text += "<div id=\"tip\" role=\"status\" hidden></div>\n";
  text += fmt::format("<script type=\"application/json\" id=\"details\">{}</script>\n",
                      json_for_script(details_json(page)));
  return text + fmt::format("<script>\n{}</script>\n</body></html>\n", resource("assets/page/study.js"));
}

}  // namespace gbl
