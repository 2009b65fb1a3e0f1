#include "tests/fuzz/readers.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <sys/mman.h>
#include <unistd.h>

#include "app/calibration.h"
#include "app/commands.h"
#include "app/driver_report.h"
#include "app/session.h"
#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/base/random.h"
#include "renderer/base/resources.h"
#include "renderer/exercises/answer.h"
#include "renderer/figures/figure_spec.h"
#include "renderer/gbuffer/layout_header.h"
#include "renderer/lessons/lessons.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/exr.h"
#include "renderer/picture/image.h"
#include "renderer/scenes/rig.h"
#include "renderer/study/journal.h"
#include "renderer/study/row_json.h"
#include "renderer/study/stability/stability_journal.h"
#include "renderer/study/study_spec.h"

namespace gbl::test {
namespace {

void demand(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

// Bytes as a file that no disk keeps.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : file_(memfd_create("gbl-fuzz", 0)) {
    demand(file_ >= 0 && write(file_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
           "a file in memory");
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::filesystem::path path() const { return fmt::format("/proc/self/fd/{}", file_); }

 private:
  int file_;
};

std::string bytes_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Seed seed(std::string name, std::string_view text) { return {std::move(name), Bytes(text.begin(), text.end())}; }

// What `make` writes to the path that it is given.
template <class Make>
Seed written(const std::string& name, Make make) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("gbl-seed-{}-{}", getpid(), name);
  make(path);
  const std::string bytes = bytes_of_file(path);
  std::filesystem::remove(path);
  return seed(name, bytes);
}

std::vector<Seed> resources_as_seeds(const char* folder) {
  std::vector<Seed> out;
  for (const std::string& name : resource_names(folder))
    out.push_back(seed(name.substr(name.rfind('/') + 1), resource(name)));
  return out;
}

// ---- glTF ------------------------------------------------------------------------------------------------------

// What a renderer takes for granted.
void read_gltf(std::string_view bytes) {
  const Scene scene = load_gltf_from_memory({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, "fuzz");
  demand(!scene.instances.empty() || !scene.warnings.empty(), "something is to be seen, or it is said why not");
  demand(scene.camera.far > scene.camera.near, "the camera sees it");
  for (const Instance& i : scene.instances) {
    demand(static_cast<size_t>(i.mesh) < scene.meshes.size(), "each object has a mesh");
    demand(static_cast<size_t>(i.material) < scene.materials.size(), "each object has a material");
  }
  for (const Mesh& mesh : scene.meshes) {
    for (const uint32_t index : mesh.indices) demand(index < mesh.vertices.size(), "indices are of vertices");
    for (const Vertex& v : mesh.vertices) {
      demand(std::isfinite(v.position.x + v.position.y + v.position.z), "positions are finite");
      demand(std::abs(glm::length(v.normal) - 1) < 1e-3f, "normals are unit");
      demand(std::abs(glm::length(glm::vec3(v.tangent)) - 1) < 1e-3f, "tangents are unit");
    }
  }
  for (const Texture& t : scene.textures) {
    const size_t words = static_cast<size_t>(t.size.x) * static_cast<size_t>(t.size.y) * 4;
    demand(t.rgba.size() == words || t.rgba16.size() == words, "textures are whole");
  }
}

// ---- pictures --------------------------------------------------------------------------------------------------

Image noise(glm::ivec2 size) {
  Pcg32 random(1);
  Image image{size, {}};
  for (int i = 0; i < 4 * size.x * size.y; ++i)
    image.rgba.push_back(static_cast<uint8_t>(random.next() | (i % 4 == 3 ? 255 : 0)));
  return image;
}

void read_png_file(std::string_view bytes) {
  const MemoryFile file(bytes);
  const Image image = read_png(file.path());
  demand(image.rgba.size() == size_t(4) * static_cast<size_t>(image.size.x) * static_cast<size_t>(image.size.y),
         "a picture is whole");
}

// A picture's settings: what `--state picture.png` reads.
void read_png_state(std::string_view bytes) {
  const MemoryFile file(bytes);
  const std::string text = read_png_text(file.path(), kSettingsKey);
  if (text.empty()) throw Error(ExitCode::bad_input, "fuzz", "holds no settings");
  parse_settings(text, "fuzz");
}

std::vector<Seed> png_seeds() {
  const PngText text = {{kSettingsKey, settings_text(preset("compact").make())}};
  const Image image = noise({5, 3});
  return {written("plain.png", [&](auto& path) { write_png(path, image, text); }),
          written("indexed.png", [&](auto& path) { write_indexed_png(path, image, text); }),
          written("sixteen.png", [&](auto& path) {
            write_png16(path, {2, 2}, std::vector<glm::vec3>(4, glm::vec3(0.3f, 0.5f, 1)), text);
          })};
}

void read_exr_file(std::string_view bytes) {
  const MemoryFile file(bytes);
  const ExrPicture picture = read_exr(file.path());
  demand(picture.rgb.size() == static_cast<size_t>(picture.size.x) * static_cast<size_t>(picture.size.y),
         "a picture is whole");
}
std::vector<Seed> exr_seeds() {
  const std::vector<float> values = {0, 0.5f, 1, 1e9f, -1, 3};
  return {written("three.exr", [&](auto& path) {
    write_exr(path, {3, 2}, {{"R", values}, {"G", values}, {"B", values}, {"object.id", values, true}},
              {{"comment", "…"}});
  })};
}

// ---- what the lab itself writes, and people after it -----------------------------------------------------------

void read_settings_text(std::string_view text) {
  const Settings s = parse_settings(text, "fuzz");
  demand(parse_settings(settings_text(s), "again") == s, "settings are read back as they were written");
}
std::vector<Seed> settings_seeds() {
  std::vector<Seed> out;
  for (const Preset& p : presets()) out.push_back(seed(p.id, settings_text(p.make())));
  return out;
}

void read_assignments(std::string_view text) {
  Settings s;
  for (size_t at = 0; at <= text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    apply_assignment(s, text.substr(at, end - at));
    at = end + 1;
  }
}
std::vector<Seed> assignment_seeds() {
  return {
      seed("options",
           "lights.cull=none\nlayout=compact\ncamera.position=[1,2,3]\nsize=[64,36]\nmistakes=[\"range-shortcut\"]"
           "\nexposure=0.5"),
      seed("sets",
           "shading.exponent=from-roughness\nlights.count=16384\nview.error.of=normal\nbackground.colour=[0.1,0.2,1]")};
}

void read_rig(std::string_view text) {
  for (const Light& l : parse_rig(text, "fuzz"))
    demand(std::isfinite(glm::length(l.position) + glm::length(l.colour)), "lights are finite");
}
std::vector<Seed> rig_seeds() {
  return {seed("rig.json", R"({"version": 1, "lights": [
  {"kind": "point", "position": [1, 2, 3], "candela": 5, "range": 4},
  {"kind": "spot", "position": [0, 5, 0], "direction": [0, -1, 0], "colour": [1, 0.5, 0], "candela": 2, "inner_deg": 10, "outer_deg": 30,
   "attenuation": [1, 0.1, 0.01]},
  {"kind": "directional", "direction": [0.3, -1, 0], "lux": 3}]})")};
}

void read_lesson(std::string_view text) {
  const Lesson lesson = parse_lesson("fuzz", text);
  for (size_t k = 0; k < lesson.steps.size(); ++k) settings_at(lesson, k), view_at(lesson, k);
}
void read_figures(std::string_view text) { parse_figures(text, "fuzz", "fuzz"); }
void read_study(std::string_view text) { parse_study(text, "fuzz"); }
void read_exercise(std::string_view text) { parse_exercise("fuzz", text); }

// The first byte says to which of the built-in exercises.
void read_answer(std::string_view text) {
  static const std::vector<Exercise> all = load_exercises();
  if (text.empty()) throw Error(ExitCode::bad_input, "fuzz", "is empty");
  parse_answer(all[static_cast<uint8_t>(text[0]) % all.size()], text.substr(1), "fuzz");
}
// What a student begins with; of a choice the first.
std::vector<Seed> answer_seeds() {
  std::vector<Seed> out;
  const std::vector<Exercise> all = load_exercises();
  for (size_t i = 0; i < all.size(); ++i) {
    const Exercise& e = all[i];
    const std::string text = e.answer == AnswerKind::choice
                                 ? Json{{"exercise", e.id}, {"answer", e.choices.front().id}}.dump()
                                 : template_of(e);
    out.push_back(seed(e.id, fmt::format("{}{}", static_cast<char>(i), text)));
  }
  return out;
}

void read_journal(std::string_view text) {
  const JournalLines lines = parse_journal(text, "fuzz");
  demand(lines.whole_bytes <= text.size(), "a journal is not longer than its file");
  for (const StudyRow& row : lines.rows)
    demand(parse_journal_line(journal_line(row), "again").has_value(), "a row is read back");
}
std::vector<Seed> journal_seeds() {
  StudyRow row;
  row.study = "tradeoff", row.name = "a", row.key = row_key({}), row.settings = preset("compact").make();
  row.at = {{"layout", OptionValue(std::string("compact"))}};
  row.cells = {{"flip_mean", Number{0.25}}, {"device", std::string("llvmpipe")}, {"time_ms_total_median", {}}};
  StudyRow failed = row;
  failed.name = "b", failed.cells.clear(), failed.failed = "no memory";
  return {seed("rows.jsonl", journal_line(row) + journal_line(failed)),
          seed("torn.jsonl", journal_line(row) + "{\"study\": \"tr")};
}

void read_session(std::string_view text) {
  const Session s = parse_session(text, "fuzz");
  demand(parse_session(session_text(s), "again").recent == s.recent, "a session is read back");
}
std::vector<Seed> session_seeds() {
  Session s;
  s.recent = {"/models/a.glb"};
  s.last.emplace();
  return {seed("session.json", session_text(s)), seed("empty.json", session_text({}))};
}

void read_layout(std::string_view text) {
  const LayoutHeader header = parse_layout_header(text, "fuzz");
  demand(header.bytes() > 0 && !header.attachments.empty(), "a layout stores something");
}
std::vector<Seed> layout_seeds() {
  return {seed("two.glsl",
               "// attachments: material RGBA8 { rgb: albedo, sRGB-coded; a: roughness } reflectance RG8 { r: metal; "
               "g: occlusion }\n")};
}

// A word a line. Help is left out: it fills the log.
void read_command_line(std::string_view text) {
  std::vector<std::string> words{"gbufferlab"};
  for (size_t at = 0; at <= text.size();) {
    const size_t end = std::min(text.find_first_of(std::string_view("\n\0", 2), at), text.size());
    words.emplace_back(text.substr(at, end - at));
    if (words.back() == "--help-all" || words.back() == "--help" || words.back() == "-h")
      throw Error(ExitCode::bad_input, "fuzz", "asks for help");
    at = end + 1;
  }
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  if (const auto a = parse_arguments(static_cast<int>(pointers.size()), pointers.data())) given_of(*a);
}
std::vector<Seed> command_line_seeds() {
  return {seed("render",
               "render\n--scene\nbuiltin:room\n--size\n64x36\n--set\nlights.cull=none\n--only\nfinal,depth\n-o\nx"),
          seed("study", "study\ntradeoff\n--budget\n1h30m\n--shard\n1/2\n--axes\nlayout,depth.format\n--json"),
          seed("camera", "view\n--camera\n1,2,3:45,-10:60\n--seed\n7\n--time=0.5\n--lights=16\n--preset\ncompact"),
          seed("exercise", "exercise\npack-smaller\n--check\n-\n--limit\n2.5\n--without\ncompute")};
}

void read_calibration(std::string_view bytes) {
  const MemoryFile file(bytes);
  std::string trouble;
  const WorkWeights weights = weights_for(file.path(), {}, trouble);
  for (const WorkRow& r : kWork) demand(std::isfinite(weights.units[r.work]), "a weight is finite");
  if (!trouble.empty()) throw Error(ExitCode::bad_input, "fuzz", trouble);
}
std::vector<Seed> calibration_seeds() {
  return {written("calibration.json", [](auto& path) { keep_calibration(path, {}, llvmpipe_weights()); })};
}

void read_driver_report(std::string_view bytes) {
  const MemoryFile file(bytes);
  driver_table({file.path(), file.path()});
}
std::vector<Seed> driver_report_seeds() {
  const Json report{
      {"gl", "4.5"},
      {"device", "d"},
      {"self_test",
       {{{"id", "a"}, {"hash", "1"}, {"flip_mean", 0.1}, {"holds", true}}, {{"id", "b"}, {"skipped", "no compute"}}}},
      {"format_checks", {{{"id", "oct8"}, {"holds", true}}}}};
  return {seed("report.json", report.dump(1))};
}

void read_sweep_points(std::string_view text) {
  for (const StudyRow& row : parse_journal(text, "fuzz").rows) point_of(row);
}
std::vector<Seed> sweep_point_seeds() {
  SweepRow point;
  point.x = 0.5, point.value = 3;
  return {seed("points.jsonl", journal_line(journal_row("near-plane/depth d24/0.5/", point, {}, "made by a test")))};
}

constexpr Reader kReaders[] = {
    {"gltf", read_gltf, seeds},
    {"png", read_png_file, png_seeds},
    {"png-state", read_png_state, png_seeds},
    {"exr", read_exr_file, exr_seeds},
    {"settings", read_settings_text, settings_seeds},
    {"assignments", read_assignments, assignment_seeds},
    {"rig", read_rig, rig_seeds},
    {"lesson", read_lesson, [] { return resources_as_seeds("assets/lessons/"); }},
    {"figures", read_figures, [] { return resources_as_seeds("assets/figures/"); }},
    {"study", read_study, [] { return resources_as_seeds("assets/studies/"); }},
    {"exercise", read_exercise, [] { return resources_as_seeds("assets/exercises/"); }},
    {"answer", read_answer, answer_seeds},
    {"journal", read_journal, journal_seeds},
    {"session", read_session, session_seeds},
    {"layout", read_layout, layout_seeds},
    {"command-line", read_command_line, command_line_seeds},
    {"calibration", read_calibration, calibration_seeds},
    {"driver-report", read_driver_report, driver_report_seeds},
    {"sweep-points", read_sweep_points, sweep_point_seeds},
};

}  // namespace

std::span<const Reader> readers() { return kReaders; }

const Reader* reader_named(std::string_view name) {
  for (const Reader& r : kReaders)
    if (name == r.name) return &r;
  return nullptr;
}

bool takes(const Reader& reader, std::string_view bytes) {
  try {
    reader.read(bytes);
    return true;
  } catch (const Error& e) {
    const std::string_view line = e.what();
    demand(e.code() == ExitCode::bad_input, "bad bytes are bad input");
    demand(!line.empty() && printable(line, line.size()) == line, "a refusal is one line that can be printed");
    return false;
  }
}

}  // namespace gbl::test
