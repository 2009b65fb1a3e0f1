#include "ui/closed_sets.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/scenes/builtin_scenes.h"

namespace gbl::ui {
namespace {

std::vector<ClosedItem> scene_items() {
  std::vector<ClosedItem> out;
  for (const BuiltinScene& s : builtin_scenes()) out.push_back({fmt::format("builtin:{}", s.id), s.label, s.help});
  return out;
}

template <bool kMarks>
std::vector<ClosedItem> view_items() {
  std::vector<ClosedItem> out;
  for (const ViewRow& v : views())
    if (!kMarks || v.marks) out.push_back({v.id, v.label, v.sentence});
  return out;
}

std::vector<ClosedItem> mistake_items() {
  std::vector<ClosedItem> out;
  for (const MistakeRow& m : mistakes()) out.push_back({m.id, m.label, m.help});
  return out;
}

struct ClosedSet {
  const char* path;
  std::vector<ClosedItem> (*items)();
};
constexpr ClosedSet kSets[] = {{"scene", scene_items},
                               {"view.main", view_items<false>},
                               {"mistakes", mistake_items},
                               {"view.overlays", view_items<true>}};

// What is chosen now: one id, or those of a set without what stands behind their colon.
std::vector<std::string> chosen_ids(const Option& o, const Settings& s) {
  const OptionValue value = o.get(s);
  if (const auto* text = std::get_if<std::string>(&value)) return {*text};
  std::vector<std::string> ids;
  for (const OptionValue& part : std::get<OptionList>(value)) {
    const std::string& text = std::get<std::string>(part);
    ids.push_back(text.substr(0, text.find(':')));
  }
  return ids;
}

bool among(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

void choose(FrameContext& f, const Option& o, const std::vector<std::string>& ids) {
  if (o.kind == Kind::text)
    edit_option(f, o, ids.front());
  else
    edit_option(f, o, OptionList(ids.begin(), ids.end()));
}

// The first by its label, and how many more.
std::string now_in_words(const Option& o, const Settings& s) {
  const std::vector<std::string> ids = chosen_ids(o, s);
  if (ids.empty()) return "none";
  const std::vector<ClosedItem> items = closed_items(o);
  const auto item = std::find_if(items.begin(), items.end(), [&](const ClosedItem& i) { return i.id == ids[0]; });
  const std::string first = item == items.end() ? ids[0] : item->label;
  return ids.size() == 1 ? first : fmt::format("{} and {} more", first, ids.size() - 1);
}

}  // namespace

std::vector<ClosedItem> closed_items(const Option& o) {
  for (const ClosedSet& s : kSets)
    if (std::string_view(s.path) == o.path) return s.items();
  return {};
}

void toggle_closed(FrameContext& f, const Option& o, const std::string& id) {
  if (o.kind == Kind::text) return edit_option(f, o, id);
  OptionList parts = std::get<OptionList>(o.get(f.settings));
  const std::vector<std::string> ids = chosen_ids(o, f.settings);
  if (const auto at = std::find(ids.begin(), ids.end(), id); at != ids.end())
    parts.erase(parts.begin() + (at - ids.begin()));
  else
    parts.emplace_back(id);
  edit_option(f, o, parts);
}

void step_closed(FrameContext& f, const Option& o, int step) {
  const std::vector<ClosedItem> items = closed_items(o);
  const std::vector<std::string> ids = chosen_ids(o, f.settings);
  const bool set = o.kind != Kind::text;
  const int n = static_cast<int>(items.size()) + (set ? 1 : 0);
  int now = set ? static_cast<int>(items.size()) : 0;  // none, of a set
  for (size_t i = 0; i < items.size(); ++i)
    if (!ids.empty() && items[i].id == ids.front()) now = static_cast<int>(i);
  const int next = (now + step + n) % n;
  if (next == static_cast<int>(items.size()))
    choose(f, o, {});
  else
    choose(f, o, {items[static_cast<size_t>(next)].id});
}

void draw_closed(FrameContext& f, const Option& o, const Box& place, float px) {
  const Box box{{std::floor(place.min.x), std::floor(place.min.y)}, {std::floor(place.max.x), std::floor(place.max.y)}};
  const std::string now = now_in_words(o, f.settings);
  const float pad = std::round(px * 0.5f);
  px = f.painter.fit(now, {box.width() - box.height() - 2 * pad, box.height()}, px, false);
  const FontScope font(px);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {pad, std::floor((box.height() - px) / 2)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
  ImGui::SetCursorScreenPos(box.min);
  ImGui::SetNextItemWidth(box.width());
  if (ImGui::BeginCombo(fmt::format("##{}", o.path).c_str(), now.c_str(), ImGuiComboFlags_HeightLarge)) {
    const std::vector<std::string> ids = chosen_ids(o, f.settings);
    const bool set = o.kind != Kind::text;
    for (const ClosedItem& item : closed_items(o)) {
      const bool on = among(ids, item.id);
      const std::string text = fmt::format("{}{}", set ? (on ? "✓ " : "    ") : "", item.label);
      if (ImGui::Selectable(text.c_str(), on, set ? ImGuiSelectableFlags_DontClosePopups : 0))
        toggle_closed(f, o, item.id);
      if (ImGui::IsItemHovered()) {
        ImGui::SetNextWindowPos({ImGui::GetWindowPos().x - 4, ImGui::GetItemRectMin().y}, ImGuiCond_Always, {1, 0});
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(f.type.body * 26);
        ImGui::TextUnformatted(item.help);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
      }
    }
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace gbl::ui
