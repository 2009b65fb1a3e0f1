#pragma once
// Where the source folder and the program stand. Functions, so that no test is compiled with a path in its command line
// (a compiler cache would know it in one folder alone).
#include <filesystem>
#include <string>

namespace gbl::test {

std::filesystem::path source_folder();
std::string program();  // the built gbufferlab

}  // namespace gbl::test
