#include "renderer/figures/captions.h"

#include <fmt/format.h>

#include "renderer/base/json.h"
#include "renderer/inspect/views.h"

namespace gbl {
namespace {

std::string with_full_stop(std::string text) {
  if (!text.empty() && std::string_view(".!?:").find(text.back()) == std::string_view::npos) text += '.';
  return text;
}

std::string letter(size_t i) { return fmt::format("({})", char('a' + i % 26)); }

void append(std::string& text, const std::string& sentence) {
  if (sentence.empty()) return;
  if (!text.empty()) text += ' ';
  text += with_full_stop(sentence);
}

// Everything below a picture but the command.
std::string whole_caption(const FigureWords& w, std::string (*escaped)(std::string_view)) {
  std::string text = escaped(w.caption);
  if (!w.source.empty()) append(text, "After: " + escaped(w.source));
  return text;
}

// A drawing is included by the package svg, which has no alt text: it stands in a comment then.
std::string latex_picture(const FigureWords& w) {
  const std::string& file = w.on_paper.empty() ? w.file : w.on_paper;
  const std::string width = w.width_cm > 0 ? fmt::format("{:.4g}cm", w.width_cm) : "\\linewidth";
  if (file.ends_with(".svg"))
    return fmt::format("  % {}\n  \\includesvg[width={}]{{{}}}\n", w.alt, width, file.substr(0, file.size() - 4));
  return fmt::format("  \\includegraphics[width={},alt={{{}}}]{{{}}}\n", width, latex_escaped(w.alt), file);
}

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '\\': out += "\\textbackslash{}"; break;
      case '~': out += "\\textasciitilde{}"; break;
      case '^': out += "\\textasciicircum{}"; break;
      case '<': out += "\\textless{}"; break;
      case '>': out += "\\textgreater{}"; break;
      case '"': out += "\\symbol{34}"; break;  // \\textquotedbl wants another encoding of fonts
      case '{':
      case '}':
      case '#':
      case '$':
      case '%':
      case '&':
      case '_': out += '\\'; [[fallthrough]];
      default: out += c;
    }
  return out;
}

std::string markdown_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|#").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string panel_words(const FigureSpec& f) {
  std::string text;
  for (size_t i = 0; i < f.panels.size(); ++i)
    if (!f.panels[i].words.empty())
      append(text, f.letters && f.panels.size() > 1 ? letter(i) + " " + f.panels[i].words : f.panels[i].words);
  return text;
}

std::string alt_text(const FigureSpec& f) {
  if (!f.alt.empty()) return f.alt;
  std::string text = with_full_stop(f.title);
  for (size_t i = 0; i < f.panels.size(); ++i) {
    const ViewRow& v = row(view_by_id(f.panels[i].view).view);
    const std::string& words = f.panels[i].words;
    const std::string said = words.empty() ? fmt::format("{}: {}", v.label, v.sentence) : words;
    append(text, f.panels.size() > 1 ? letter(i) + " " + said : said);
  }
  return text;
}

std::string markdown_caption(const FigureWords& w) {
  return fmt::format("![{}]({})\n\n*{}*\n\nMade with G-Buffer Lab {}:\n\n```\n{}\n```\n", markdown_escaped(w.alt),
                     w.file, whole_caption(w, markdown_escaped), w.made_by, w.command);
}

std::string latex_caption(const FigureWords& w) {
  return fmt::format(
      "% G-Buffer Lab {}\n% {}\n\\begin{{figure}}\n  \\centering\n{}  \\caption{{{}}}\n  "
      "\\label{{fig:{}}}\n\\end{{figure}}\n",
      w.made_by, w.command, latex_picture(w), whole_caption(w, latex_escaped), w.id);
}

Json caption_json(const FigureWords& w) {
  return {
      {"id", w.id},           {"file", w.file},       {"title", w.title},
      {"caption", w.caption}, {"alt", w.alt},         {"source", w.source},
      {"command", w.command}, {"made_by", w.made_by}, {"width_cm", w.width_cm > 0 ? Json(w.width_cm) : Json(nullptr)}};
}

}  // namespace gbl
