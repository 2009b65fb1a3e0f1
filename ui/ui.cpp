#include "ui/ui.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "renderer/frame/resolve.h"
#include "ui/in_words.h"
#include "ui/keys.h"
#include "ui/presenting.h"
#include "ui/state.h"
#include "ui/talk.h"

namespace gbl::ui {
namespace {

constexpr float kPresentScale = 1.5f;
const ImVec2 kLeastWindow = {160, 90};  // below this nothing could be read, and parts of the screen have no area

LayoutInput layout_input(const State& s, const Settings& settings, const Settings& stored, const Type& type) {
  return {.display = ImGui::GetIO().DisplaySize,
          .chosen = view_by_id(settings.view.main).view,
          .large = s.large,
          .page = s.page == 0 ? settings.view.panels : page_of(stored, s.page),
          .hidden = s.hidden,
          .present = s.present,
          .beside = panel_beside(s) || (s.present && letters_are_a_panels(s)),  // large type needs half of the screen
          .status_height = s.present ? 0 : status_height(type)};
}

// A larger window has larger type.
float unit_of(ImVec2 display) { return std::min(display.x / 1600, display.y / 900); }

Type type_of(const State& s) {
  return type_for(unit_of(ImGui::GetIO().DisplaySize) * s.ui_scale * (s.present ? kPresentScale : 1));
}

void begin_root(ImVec2 display) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(display);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(kRootWindow, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
}

// Keys change what the layout is made from: afterwards the frame is measured again.
void take_input(FrameContext& f, const std::vector<KeyEvent>& keys) {
  if (f.state.caption && f.input.seconds >= f.state.caption->until) f.state.caption.reset();
  if (!f.state.focus_field || f.state.field.empty()) f.state.entered = false;  // else the field has not seen it yet
  f.state.field_key.clear();
  for (const KeyEvent& e : std::exchange(f.state.chosen, {})) dispatch(f, e);
  for (const KeyEvent& e : keys) dispatch(f, e);
  advance_motion(f);
  f.type = type_of(f.state);
  f.stored = resolve(f.settings, f.input.scene).settings;
  f.layout = make_layout(layout_input(f.state, f.settings, f.stored, f.type));
  make_room(f);
  f.layout.foot = presenting_foot(f);
}

}  // namespace

Ui::Ui(Settings initial, bool present) : state_(std::make_unique<State>(std::move(initial), present)) {}
Ui::~Ui() = default;

void Ui::set_up_style() { ui::set_up_style(); }

Requests Ui::draw(Settings& settings, const Input& input, const std::vector<KeyEvent>& keys) {
  State& s = *state_;
  s.cut_texts.clear();
  Requests requests;
  use_theme(s.light ? kLightTheme : kDarkTheme);
  begin_root(ImGui::GetIO().DisplaySize);
  if (ImGui::GetIO().DisplaySize.x < kLeastWindow.x || ImGui::GetIO().DisplaySize.y < kLeastWindow.y) {
    ImGui::End();
    return requests;
  }
  FrameContext f{s, settings, input, requests, {}, {}, Painter(*ImGui::GetWindowDrawList(), s.cut_texts)};
  f.type = type_of(s);
  f.stored = resolve(settings, input.scene).settings;
  f.layout = make_layout(layout_input(s, settings, f.stored, f.type));
  s.history.see(settings);
  take_input(f, keys);

  f.painter.fill({{0, 0}, ImGui::GetIO().DisplaySize}, s.present ? IM_COL32_BLACK : theme().background);
  draw_pictures(f);
  if (s.present) {
    if (!s.hidden) draw_presenting(f);
  } else if (!s.hidden) {
    draw_strip(f);
    draw_control_column(f);
    draw_status_bar(f);
  } else {
    if (s.lesson) draw_lesson(f, f.layout.strip);
    draw_hidden_hint(f);
  }
  if (s.caption) requests.wake_in = std::max(0.0, s.caption->until - input.seconds);
  draw_talk_timer(f);
  ImGui::End();
  draw_panels(f);
  draw_notices(f);
  draw_reticle(f);
  requests.in_words = in_words(f);
  return requests;
}

void Ui::start_type(float content_scale, glm::vec2 display) {
  if (content_scale <= 1 || display.x <= 0 || display.y <= 0) return;
  state_->ui_scale = std::clamp(content_scale / unit_of({display.x, display.y}), 1.0f, kLargestScale);
}

Snapshot Ui::snapshot(const Settings& settings) const { return {settings, state_->large}; }

void Ui::show(const Snapshot& kept, Settings& settings) {
  const glm::ivec2 size = settings.size;
  settings = kept.settings;
  settings.size = size;
  state_->large = kept.large;
  state_->glide.reset();
  state_->before_glide.reset();
}

const Bookmarks& Ui::bookmarks() const { return state_->bookmarks; }
void Ui::set_bookmarks(const Bookmarks& kept) { state_->bookmarks = kept; }

void Ui::open_lesson(const std::string& place, Settings& settings) {
  ui::open_lesson(*state_, settings, load_lesson_place(place));
}

std::string Ui::lesson_place() const {
  const auto& run = state_->lesson;
  return run ? fmt::format("{}:{}", run->lesson.id, run->step + 1) : "";
}

void Ui::open_pitfall(std::string_view id, Settings& settings) { ui::open_pitfall(*state_, settings, id); }

void Ui::compare_with(std::string file) { set_b_to_file(state_->comparison, std::move(file)); }

bool Ui::moving(const Settings&) const {
  return state_->playing || state_->glide || state_->camera_key || state_->on_path;
}

bool Ui::is_open(std::string_view panel) const { return ui::is_open(*state_, panel); }

const std::vector<std::string>& Ui::cut_texts() const { return state_->cut_texts; }

}  // namespace gbl::ui
