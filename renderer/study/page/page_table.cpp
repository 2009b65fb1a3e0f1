#include <fmt/format.h>

#include "renderer/study/page/html_text.h"
#include "renderer/study/page/page.h"

namespace gbl {
namespace {

// Names of columns may be broken after each word.
std::string breakable(const std::string& html) {
  std::string out;
  for (const char c : html) out += c == '_' ? std::string("_<wbr>") : std::string(1, c);
  return out;
}

std::string heading(const PageColumn& c) {
  const std::string help = c.help.empty() ? "" : fmt::format(" title=\"{}\"", html_text(c.help));
  return fmt::format("<th scope=\"col\"{}><span>{}</span></th>", help, breakable(html_text(c.title)));
}

std::string cell(const PageCell& c) {
  if (!c.number) return fmt::format("<td>{}</td>", html_text(c.text));
  return fmt::format("<td class=\"number\" data-n=\"{}\">{}</td>", *c.number, html_text(c.text));
}

std::string thumbnail(const std::string& bytes, const char* type, const char* what, const PageRow& row) {
  if (bytes.empty()) return fmt::format("<span class=\"none\">no {}</span>", what);
  return fmt::format(R"(<img loading="lazy" alt="{} of {}" src="{}">)", what, html_text(row.words),
                     data_url(type, bytes));
}

std::string pictures(const PageRow& row) {
  if (!row.failed.empty()) return "<td></td>";
  return fmt::format("<td class=\"pictures\">{}{}</td>",
                     thumbnail(row.thumbnails.picture, "image/jpeg", "picture", row),
                     thumbnail(row.thumbnails.error_map, "image/png", "error map", row));
}

std::string sound(const PageRow& row) {
  if (row.unsound.empty()) return "<td>sound</td>";
  return fmt::format("<td class=\"bad\">\u26a0 {}</td>", html_text(row.unsound));
}

// All its cells, or why there are none.
std::string numbers(const Page& page, const PageRow& row) {
  if (!row.failed.empty())
    return fmt::format("<td class=\"bad\" colspan=\"{}\">failed: {}</td>", page.columns.size(), html_text(row.failed));
  std::string text;
  for (const PageCell& c : row.cells) text += cell(c);
  return text;
}

std::string table_row(const Page& page, size_t index) {
  const PageRow& row = page.rows[index];
  std::string text = fmt::format("<tr data-row=\"{}\"{}>", index, row.marked ? " class=\"marked\"" : "");
  text += fmt::format("<td class=\"js\"><input type=\"checkbox\" data-pick=\"{}\" aria-label=\"compare {}\"></td>",
                      index, html_text(row.words));
  if (page.pictures) text += pictures(row);
  text += fmt::format("<th scope=\"row\">{}{}</th>",
                      row.marked ? fmt::format("<b>{}:</b> ", html_text(page.marked)) : "", html_text(row.words));
  text += sound(row) + numbers(page, row);
  return text + fmt::format(
                    "<td class=\"command\"><details><summary>command</summary><code>{}</code></details>"
                    "<button class=\"js\" type=\"button\" data-copy>copy</button></td></tr>\n",
                    html_text(row.command));
}

std::string error_steps() {
  std::string text =
      "<p class=\"steps\">Error map: each dot is the worst of the pixels below it, in codes of 255 as displayed. ";
  for (const ErrorStep& s : kErrorSteps)
    text += fmt::format("<span><i style=\"background:#{:02x}{:02x}{:02x}\"></i>{}</span> ", s.colour[0], s.colour[1],
                        s.colour[2], html_text(s.words));
  return text + "</p>\n";
}

}  // namespace

std::string page_table(const Page& page) {
  std::string text = fmt::format("<section id=\"rows\"><h2>{}</h2>\n<p>{}</p>\n", html_text(page.rows_are),
                                 html_text(page.commands_are));
  if (page.rows.empty()) return text + "<p>None has been measured.</p></section>\n";
  text +=
      "<p class=\"js\"><label>Filter: <input type=\"search\" id=\"filter\" placeholder=\"words, all of which must "
      "match\"></label> <output id=\"count\" aria-live=\"polite\"></output></p>\n";
  if (page.pictures) text += error_steps();
  text += "<div class=\"wide\"><table><thead><tr><td class=\"js\">compare</td>";
  if (page.pictures) text += "<td>picture, error map</td>";
  text += heading({"set-up"}) + heading({"sound"});
  for (const PageColumn& c : page.columns) text += heading(c);
  text += "<td>command</td></tr></thead>\n<tbody>\n";
  for (size_t i = 0; i < page.rows.size(); ++i) text += table_row(page, i);
  return text + "</tbody></table></div></section>\n";
}

}  // namespace gbl
