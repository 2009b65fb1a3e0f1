#pragma once
// Where the source folder, the build folder and the program stand. Functions, so that no test is compiled with a path in its command line
// (a compiler cache would know it in one folder alone).
#include <filesystem>
#include <string>

namespace gbl::test {

std::filesystem::path source_folder();
std::filesystem::path build_folder();  // what a test leaves behind belongs below it
std::string program();                 // the built gbufferlab

}  // namespace gbl::test
