// The file of calibrations: what was kept is found again for its device alone, and a damaged file is said and not used.
#include "app/calibration.h"

#include <filesystem>

#include "renderer/base/files.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

class Calibration : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "calibration";
    fs::remove_all(folder_);
    gpu_.renderer = "Some GPU", gpu_.version = "4.6";
    llvmpipe_.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)", llvmpipe_.version = "4.5";
  }
  void TearDown() override { fs::remove_all(folder_); }
  WorkWeights found(const gl::Device& device) { return weights_for(file(), device, trouble_); }
  fs::path file() const { return folder_ / "deeper" / "calibration.json"; }

  fs::path folder_;
  gl::Device gpu_, llvmpipe_;
  std::string trouble_;
};

TEST_F(Calibration, WithoutAFileOtherDevicesThanLlvmpipeAreGuessed) {
  EXPECT_TRUE(found(gpu_).guessed);
  EXPECT_FALSE(found(llvmpipe_).guessed);
  EXPECT_EQ(found(gpu_).units, llvmpipe_weights().units);
  EXPECT_TRUE(weights_for({}, gpu_, trouble_).guessed);
  EXPECT_EQ(trouble_, "");
}

TEST_F(Calibration, WhatWasKeptIsFoundForItsDeviceAlone) {
  WorkWeights mine = llvmpipe_weights();
  mine.units[Work::quad] = 17.25, mine.ns_per_unit = 0.02;
  keep_calibration(file(), gpu_, mine);
  EXPECT_EQ(found(gpu_), mine);
  EXPECT_FALSE(found(llvmpipe_).guessed);
  EXPECT_EQ(found(llvmpipe_).units, llvmpipe_weights().units);
  WorkWeights other = llvmpipe_weights();
  other.ns_per_unit = 3;
  keep_calibration(file(), llvmpipe_, other);
  EXPECT_EQ(found(gpu_), mine) << "one device's do not replace another's";
  EXPECT_EQ(found(llvmpipe_), other);
  gl::Device updated = gpu_;
  updated.version = "4.7";
  EXPECT_TRUE(found(updated).guessed) << "another driver";
  EXPECT_EQ(trouble_, "");
}

TEST_F(Calibration, ADamagedFileIsSaidNotUsedAndWrittenAnew) {
  fs::create_directories(file().parent_path());
  for (const char* text : {"{", "[]", R"({"version": 99, "devices": {}})", R"({"version": 1})",
                           R"({"version": 1, "devices": {"Some GPU, 4.6": {"ns_per_unit": 1}}})",
                           R"({"version": 1, "devices": {"Some GPU, 4.6": {"ns_per_unit": "fast"}}})"}) {
    write_text_file(file(), text);
    trouble_.clear();
    EXPECT_TRUE(found(gpu_).guessed) << text;
    EXPECT_NE(trouble_.find("calibration.json"), std::string::npos) << text;
    EXPECT_NE(trouble_.find("bench --calibrate"), std::string::npos) << text;
  }
  keep_calibration(file(), gpu_, llvmpipe_weights());
  trouble_.clear();
  EXPECT_FALSE(found(gpu_).guessed);
  EXPECT_EQ(trouble_, "");
}

}  // namespace
}  // namespace gbl
