// A choice as a combo: the same rows, marks and reasons wherever it stands.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/frame/validate.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

// Why this value cannot be chosen as things stand; empty if it can.
std::string why_not(const FrameContext& f, const Option& o, const ValueRow& r) {
  if (!f.input.features.has(r.needs)) {
    const FeatureRow& feature = kFeatures[static_cast<int>(r.needs) - 1];
    return fmt::format("needs {}, which is not available here ({})", feature.id, feature.used_for);
  }
  Settings changed = f.settings;
  o.set(changed, r.id, o);
  const std::vector<Problem> problems = validate(changed, {f.input.features});
  return problems.empty() ? "" : problems.front().sentence;
}

void draw_value(FrameContext& f, const Option& o, const ValueRow& r, bool selected) {
  const std::string reason = selected ? "" : why_not(f, o, r);
  const bool available = reason.empty();
  std::string text = r.sound() ? r.label : fmt::format("{} {}", kUnsoundSign, r.label);
  if (*r.cost) text += fmt::format("   {}", r.cost);
  if (!r.sound()) text += fmt::format("   unsound: {}", id_of(r.pitfall));
  if (!available) text += f.input.features.has(r.needs) ? "   not with these settings" : "   " + reason;
  ImGui::PushStyleColor(ImGuiCol_Text, r.sound() ? theme().text : theme().unsound);
  if (ImGui::Selectable(text.c_str(), selected, available ? 0 : ImGuiSelectableFlags_Disabled)) edit_option(f, o, r.id);
  ImGui::PopStyleColor();
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  // Left of the list, so that it hides none of the other values.
  ImGui::SetNextWindowPos({ImGui::GetWindowPos().x - 4, ImGui::GetItemRectMin().y}, ImGuiCond_Always, {1, 0});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(f.type.body * 26);
  ImGui::TextUnformatted(r.help);
  if (*r.source) ImGui::TextDisabled("%s", r.source);
  if (!available) ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(theme().unsound), "%s", reason.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

std::string sound_mark(const Option& o, const Settings& s) {
  if (o.kind != Kind::choice || o.group != Group::method || !in_use(o, s)) return {};
  const ValueRow& r = o.values[chosen(o, s)];
  return r.sound() ? "" : fmt::format("{} unsound: {}", kUnsoundSign, id_of(r.pitfall));
}

void draw_choice(FrameContext& f, const Option& o, const Box& place, float px) {
  const Box box{{std::floor(place.min.x), std::floor(place.min.y)}, {std::floor(place.max.x), std::floor(place.max.y)}};
  const ValueRow& now = o.values[chosen(o, f.settings)];
  const std::string label = value_text(o, f.settings);  // the user's file, where it stands in the place of a layout
  const float arrow = box.height(), pad = std::round(px * 0.5f);
  px = f.painter.fit(label, {box.width() - arrow - 2 * pad, box.height()}, px, false);
  const FontScope font(px);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {pad, std::floor((box.height() - px) / 2)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
  ImGui::SetCursorScreenPos(box.min);
  ImGui::SetNextItemWidth(box.width());
  if (ImGui::BeginCombo(fmt::format("##{}", o.path).c_str(), label.c_str(), ImGuiComboFlags_HeightLargest)) {
    for (const ValueRow& r : o.values) draw_value(f, o, r, r.value == now.value && label == r.label);
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace gbl::ui
