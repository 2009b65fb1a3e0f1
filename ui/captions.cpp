#include "ui/captions.h"

#include <filesystem>
#include <fmt/format.h>

#include "renderer/gbuffer/layout_file.h"

namespace gbl::ui {
namespace {

bool speaks_for_itself(const Option& o) {
  const std::string_view path = o.path;
  return path.starts_with("camera.") || path == "time_s" || path == "view.main" || path == "size";
}

std::string with_full_stop(std::string text) {
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

std::string cost_sentence(const ValueRow& before, const ValueRow& after) {
  const std::string_view now = after.cost, was = before.cost;
  if (now == was) return now.empty() ? "" : fmt::format(" Cost: {}, as before.", now);
  if (now.empty()) return fmt::format(" Costs nothing extra (was {}).", was);
  return was.empty() ? fmt::format(" Cost: {}.", now) : fmt::format(" Cost: {} (was {}).", now, was);
}

std::string plain_text(const OptionValue& v, int digits = 6) {
  if (const auto* text = std::get_if<std::string>(&v)) return *text;
  if (const auto* n = std::get_if<Number>(&v)) return n->whole ? written(v) : fmt::format("{:.{}g}", n->value, digits);
  const auto& list = std::get<OptionList>(v);
  std::string text;
  for (const OptionValue& part : list)
    text += (text.empty() ? "" : ", ") + plain_text(part, list.size() > 3 ? 3 : digits);
  return fmt::format("[{}]", text);
}

}  // namespace

std::string capitalised(std::string_view text) {
  std::string out(text);
  const bool word = out.size() > 1 && (out[1] != ' ' || out[0] == 'a');  // "n * 0.5" begins with a symbol
  if (word && out[0] >= 'a' && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

std::string grouped(uint64_t number) {
  std::string digits = std::to_string(number);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) digits.insert(at, " ");
  return digits;
}

std::string value_text(const Option& o, const Settings& s) {
  const bool in_its_place = std::string_view(o.path) == "layout" && !s.layout_file.empty();
  if (in_its_place) return std::filesystem::path(path_of_layout_file(s.layout_file)).filename().string();
  if (o.kind == Kind::choice) return o.values[chosen(o, s)].label;
  return plain_text(o.get(s));
}

Sentence describe_step(const Option& o, const Settings& before, const Settings& after) {
  const std::string was = value_text(o, before), now = value_text(o, after);
  if (o.kind != Kind::choice) {
    if (was == now) return {fmt::format("{}: {} is the end of the range.", o.label, now), ""};
    return {fmt::format("{}: {} → {}. {}", o.label, was, now, with_full_stop(capitalised(o.help))), ""};
  }
  const ValueRow& from = o.values[chosen(o, before)];
  const ValueRow& to = o.values[chosen(o, after)];
  if (from.value == to.value)
    return {
        fmt::format("{}: “{}” is the only choice here. {}", o.label, to.label, with_full_stop(capitalised(to.help))),
        ""};
  Sentence s{fmt::format("{}: {} → {}. {}{}", o.label, from.label, to.label, with_full_stop(capitalised(to.help)),
                         cost_sentence(from, to)),
             ""};
  if (!in_use(o, after) && o.use->by_lighting && after.lights.method == LightMethod::auto_)
    s.text += " The automatic method draws volumes only while this choice is sound.";
  else if (!in_use(o, after))
    s.text += fmt::format(" No effect as things stand: {} does not use it.", o.use->who_does_not(after));
  else
    s.pitfall = id_of(to.pitfall);
  return s;
}

Sentence describe_change(const Settings& before, const Settings& after) {
  const Option* only = nullptr;
  std::string labels;
  int changed = 0;
  for (const Option& o : options()) {
    if (speaks_for_itself(o) || o.get(before) == o.get(after)) continue;
    only = &o;
    ++changed;
    labels += fmt::format("{}{}", changed > 1 ? ", " : "", o.label);
  }
  if (changed == 0) return {};
  if (changed == 1) return describe_step(*only, before, after);
  return {fmt::format("{} settings changed: {}.", changed, labels), ""};
}

}  // namespace gbl::ui
