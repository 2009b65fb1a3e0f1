#include "app/imgui_screen.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "renderer/gl/device.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/readback.h"
#include "renderer/passes/targets.h"

namespace gbl {

ImguiScreen::ImguiScreen(gl::Api api) : api_(api) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // the layout is ours; nothing is written to the working folder
  ui::Ui::set_up_style();
  ImGui_ImplOpenGL3_Init(api_ == gl::Api::es3 ? "#version 300 es" : "#version 330 core");
}

ImguiScreen::~ImguiScreen() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void ImguiScreen::draw(glm::ivec2 size, const std::function<void()>& panels) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(size.x), static_cast<float>(size.y));
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  panels();
  ImGui::Render();
  glUseProgram(0);  // ImGui puts the current program back afterwards: it may be one that is deleted by then
  glViewport(0, 0, size.x, size.y);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
#ifndef IMGUI_IMPL_OPENGL_ES3
  // As it is packaged, the backend also sets what GLES has not, as how polygons are filled.
  if (api_ == gl::Api::es3)
    for (int errors = 0; errors < 8 && glGetError() != GL_NO_ERROR;) ++errors;
#endif
}

Image ImguiScreen::picture(glm::ivec2 size, const std::function<void()>& panels) {
  const Canvas canvas = make_canvas({.size = size, .format = Format::rgba8, .label = "screen"});
  glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer.id());
  draw(size, panels);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return image_from_gl_rows(size, gl::read_rgba8(canvas.texture));
}

}  // namespace gbl
