// The manual of an installed program, against the grammar and the tables that it is made from.
#include "app/manual.h"

#include <array>
#include <cstdio>
#include <fmt/format.h>
#include <sstream>

#include "app/commands.h"
#include "renderer/options/presets.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

std::string without_escapes(std::string text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\')
      out += text[i];
    else if (text[++i] == 'f')
      ++i;  // a change of type
    else if (text[i] == '-')
      out += '-';
  }
  return out;
}

TEST(Manual, ThePageHasEachCommandAndEachOption) {
  const std::string page = without_escapes(man_page());
  for (const CommandText& c : command_texts()) {
    EXPECT_TRUE(c.name.empty() || contains(page, ".SS " + c.name + "\n")) << c.name;
    for (const OptionText& o : c.options) {
      EXPECT_TRUE(contains(page, o.names)) << c.name << " " << o.names;
      EXPECT_FALSE(o.help.empty()) << c.name << " " << o.names;
    }
  }
  EXPECT_EQ(command_texts().size(), commands().size() + 1);
}

TEST(Manual, NoLineOfThePageIsTakenForACommandOfRoff) {
  std::istringstream lines(man_page());
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(!line.starts_with('.') || std::isupper(static_cast<unsigned char>(line[1]))) << line;
}

// What bash offers after this line, its last word begun.
std::string completed(const std::string& file, const std::string& words, int at) {
  const std::string script =
      "_get_comp_words_by_ref() { cur=${COMP_WORDS[COMP_CWORD]}; prev=${COMP_WORDS[COMP_CWORD-1]}; }; "
      "__ltrim_colon_completions() { :; }; compopt() { :; }; source " +
      file + "; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(at) +
      "; _gbufferlab; echo \" ${COMPREPLY[*]} \"";
  FILE* pipe = popen(("bash -c '" + script + "' 2>&1").c_str(), "r");
  std::string out;
  for (std::array<char, 512> part; fgets(part.data(), part.size(), pipe);) out += part.data();
  pclose(pipe);
  return out;
}

TEST(Manual, BashCompletesCommandsOptionsAndNames) {
  const TemporaryFolder folder("manual");
  write_manual(folder / "share");
  const std::string file = (folder / "share" / "gbufferlab").string();
  EXPECT_EQ(completed(file, "gbufferlab ren", 1), " render \n");
  EXPECT_EQ(completed(file, "gbufferlab render --she", 2), " --sheet \n");
  EXPECT_EQ(completed(file, "gbufferlab view --gl e", 3), " es3 \n");
  const std::string all = completed(file, "gbufferlab view --preset \"\"", 3);
  for (const Preset& p : presets()) EXPECT_TRUE(contains(all, std::string(" ") + p.id + " ")) << all;
  EXPECT_TRUE(contains(completed(file, "gbufferlab render --set lights.cu", 3), "lights.cull="));
}

}  // namespace
}  // namespace gbl
