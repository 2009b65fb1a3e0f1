// A lab that is used for a long time does not grow, leak or change. GBL_LONG_RUN_S=600: for ten minutes.
#include <malloc.h>

#include "renderer/base/memory.h"
#include "tests/app/long_run.h"
#include "tests/flatness.h"

namespace gbl::test {
namespace {

struct Held {
  double seconds, resident_mib, heap_mib;
  std::array<int, gl::kKinds> names;
  std::map<std::string, int> labels;  // of textures and buffers: how many bear each
};

// Mesa takes names that were free for long before new ones, if ever: half an hour takes some ten thousands.
std::map<std::string, int> labels_in_use() {
  constexpr GLuint kMostNames = 1 << 20;
  std::map<std::string, int> out;
  const auto add = [&](const char* kind, GLenum identifier, GLuint id) {
    char label[64] = "";
    if (gl::device().features.has(Feature::debug_labels))
      glGetObjectLabel(identifier, id, sizeof label, nullptr, label);
    ++out[fmt::format("{} {}", kind, label)];
  };
  for (GLuint id = 1; id < kMostNames; ++id) {
    if (glIsTexture(id)) add("texture", GL_TEXTURE, id);
    if (glIsBuffer(id)) add("buffer", GL_BUFFER, id);
  }
  return out;
}

std::string differing(const std::map<std::string, int>& a, const std::map<std::string, int>& b) {
  std::string out;
  std::map<std::string, std::pair<int, int>> counts;
  for (const auto& [label, n] : a) counts[label].first = n;
  for (const auto& [label, n] : b) counts[label].second = n;
  for (const auto& [label, n] : counts)
    if (n.first != n.second) out += fmt::format("{}: {} → {}; ", label, n.first, n.second);
  return out;
}

// In use in all arenas: mallinfo() knows the first one only.
double heap_mib() {
  char* text = nullptr;
  size_t size = 0;
  std::FILE* out = open_memstream(&text, &size);
  malloc_info(0, out);
  std::fclose(out);
  const std::string xml(text, size);
  std::free(text);
  const auto last = [&](std::string_view element) {  // the sums stand last
    const size_t at = xml.find("size=\"", xml.rfind(element)) + 6;
    return std::stod(xml.substr(at));
  };
  return (last("<system type=\"current\"") - last("<total type=\"fast\"") - last("<total type=\"rest\"") +
          last("<total type=\"mmap\"")) /
         (1 << 20);
}

class LongRuns : public GlTest {
 protected:
  static void SetUpTestSuite() {
    draw_without_threads();
    return_freed_memory();  // as the program does
  }
  void SetUp() override {
    GlTest::SetUp();
    fmt::print(
        "   seconds  cycles  resident  heap MiB  names: textures, buffers, vertex arrays, framebuffers, "
        "renderbuffers, programs, queries, …\n");
  }
  const Held& record() {
    return_free_pages();  // as a window that rests
    Held now{seconds(), resident_mib(getpid()), heap_mib(), {}, labels_in_use()};
    for (size_t k = 0; k < gl::kKinds; ++k) now.names[k] = gl::live_names(static_cast<gl::Kind>(k));
    records_.push_back(now);
    fmt::print("{:10.0f}{:8}{:10.1f}{:10.1f}  {}\n", now.seconds, records_.size() - 1, now.resident_mib, now.heap_mib,
               fmt::join(now.names, " "));
    std::fflush(stdout);
    return records_.back();
  }
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  double growth_of(double Held::*what) const {
    std::vector<Sample> samples;
    for (const Held& h : records_) samples.push_back({h.seconds, h.*what});
    return growth(samples);
  }

  std::vector<Held> records_;  // after each cycle
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

TEST_F(LongRuns, NothingGrowsLeaksOrChanges) {
  LongRun run(2026);
  run.go_back();
  const std::map<View, Image> first = run.pictures();
  const double most_s = long_run_s(180);
  // The cache of programs and the driver's of their variants.
  while (run.compiled() < 8 * static_cast<int>(ProgramCache::kMost)) run.cycle();
  constexpr size_t kFewest = 6, kMost = 30;  // cycles: to say anything, and to visit all
  do {
    run.cycle();
    record();
    for (const auto& [view, image] : run.pictures()) {
      const Image& before = first.at(view);
      ASSERT_EQ(image.size, before.size) << row(view).id << ": " << run.said();
      if (!(image == before)) {
        write_png(build_folder() / fmt::format("long-run-{}.png", row(view).id), image);
        write_png(build_folder() / fmt::format("long-run-{}-first.png", row(view).id), before);
      }
      EXPECT_TRUE(image == before) << row(view).id << " is not the first one; both are in " << build_folder();
    }
  } while (seconds() < most_s || records_.size() < kFewest || (records_.size() < kMost && !run.left_out().empty()));
  EXPECT_EQ(run.left_out(), "") << "not visited";
  EXPECT_GT(run.refused(), 0) << "nonsense was taken";
  EXPECT_LE(growth_of(&Held::resident_mib), 0.02);
  EXPECT_LE(growth_of(&Held::heap_mib), 0.02);
  for (const Held& h : after_warm_up(records_)) {
    EXPECT_EQ(h.names, records_.back().names);
    EXPECT_EQ(differing(h.labels, records_.back().labels), "");
  }
  fmt::print("{} settings drawn, {} refused on purpose; resident {:+.2f} %, heap {:+.2f} %\n", run.drawn(),
             run.refused(), 100 * growth_of(&Held::resident_mib), 100 * growth_of(&Held::heap_mib));
}

}  // namespace
}  // namespace gbl::test
