// Where the panels of the first page stand: titles are dragged onto other panels, and views are locked.
#include <algorithm>
#include <fmt/format.h>

#include "ui/state.h"
#include "ui/view_panel.h"

namespace gbl::ui {
namespace {

std::vector<LookOf> panels_now(const FrameContext& f) {
  return f.settings.view.panels.empty() ? usual_panels() : f.settings.view.panels;
}

// Of the first page, by place.
std::optional<size_t> place_at(const FrameContext& f, ImVec2 at) {
  const auto inside = [&](const Box& b) { return b.contains({at, at}); };
  for (const LockedPanel& l : f.layout.locked)
    if (inside(l.box)) return l.place;
  const std::vector<LookOf> panels = panels_now(f);
  for (size_t i = 0; i < panels.size(); ++i) {
    const auto& box = f.layout.panels[static_cast<size_t>(view_by_id(panels[i].view).view)];
    const bool locked =
        std::any_of(f.layout.locked.begin(), f.layout.locked.end(), [&](const LockedPanel& l) { return l.place == i; });
    if (!locked && box && inside(*box)) return i;
  }
  return {};
}

}  // namespace

void use_titles(FrameContext& f) {
  State& s = f.state;
  if (s.large || s.page != 0 || s.hidden) return s.carried.reset();
  const ImGuiIO& io = ImGui::GetIO();
  const std::vector<LookOf> panels = panels_now(f);
  for (size_t i = 0; i < panels.size(); ++i) {
    Box box;
    for (const LockedPanel& l : f.layout.locked)
      if (l.place == i) box = l.box;
    const auto& own = f.layout.panels[static_cast<size_t>(view_by_id(panels[i].view).view)];
    if (box.width() <= 0 && own) box = *own;
    const float px = i == 0 ? f.type.body : f.type.small;
    if (box.width() <= 0 || covered(f, box)) continue;
    const Box title{box.min, {box.min.x + std::min(box.width() * 0.4f, 12 * px), box.min.y + line_height(px) + 2}};
    if (hit_area(fmt::format("title.{}", i).c_str(), title) && io.MouseDragMaxDistanceSqr[0] <= 100)
      f.settings.view.main = view_by_id(panels[i].view).id;
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemActive() && io.MouseDragMaxDistanceSqr[0] > 100) s.carried = i;
  }
  if (!s.carried || io.MouseDown[0]) return;
  const std::optional<size_t> onto = place_at(f, io.MousePos);
  const size_t from = *s.carried;
  s.carried.reset();
  if (!onto || *onto == from) return;
  if (!panels[std::max(from, *onto)].look.plain() && std::min(from, *onto) == 0)
    return say(f, {"A locked panel cannot be the large one. Ctrl+K unlocks it.", ""});
  f.settings.view.panels = panels;
  std::swap(f.settings.view.panels[from], f.settings.view.panels[*onto]);
  if (f.settings.view.panels == usual_panels()) f.settings.view.panels.clear();
  const std::vector<LookOf> now = panels_now(f);
  say(f, {fmt::format("{} and {} have changed places.", row(view_by_id(now[*onto].view).view).label,
                      row(view_by_id(now[from].view).view).label),
          ""});
}

void draw_carried(FrameContext& f) {
  if (!f.state.carried) return;
  const View v = view_by_id(panels_now(f)[*f.state.carried].view).view;
  const ImVec2 at = ImGui::GetIO().MousePos;
  const float px = f.type.body;
  const Box back{{at.x + px, at.y}, {at.x + 2 * px + text_size(row(v).label, px).x, at.y + line_height(px)}};
  f.painter.fill(back, on_picture().backing);
  f.painter.text({back.min.x + px / 2, back.min.y + above_text(px)}, px, on_picture().accent, row(v).label);
}

void lock_panel(FrameContext& f) {
  std::vector<LookOf> panels = panels_now(f);
  const bool any = std::any_of(panels.begin() + 1, panels.end(), [](const LookOf& p) { return !p.look.plain(); });
  const View v = f.layout.main;
  LookOf now{row(v).id, look_of(f.settings.view.looks, row(v).id)};
  if (!now.look.range && !now.look.raw)  // as it stands now, whatever is seen later
    now.look.fit = false,
    now.look.range = shown_range(v, f.settings, f.input.scene.bounds, f.input.stats[static_cast<size_t>(v)]);
  if (any) {
    const std::vector<LookOf> usual = usual_panels();
    for (size_t i = 1; i < panels.size(); ++i)
      if (!panels[i].look.plain()) panels[i] = usual[i];
    f.settings.view.panels = panels == usual ? std::vector<LookOf>{} : panels;
    return say(f, {"No panel is locked any more.", ""});
  }
  if (needs_truth(v)) return say(f, {fmt::format("{} cannot be locked.", capitalised(row(v).label)), ""});
  panels.back() = now;
  f.settings.view.panels = panels;
  say(f,
      {fmt::format("Locked in the last panel: {}. The view itself may be looked at otherwise now.", text_of(now)), ""});
}

}  // namespace gbl::ui
