// What lessons say of errors, measured. At a quarter of the size that the sentences are from: means move by a few percent.
#include "app/bench.h"
#include "app/lab.h"
#include "renderer/lessons/lessons.h"
#include "renderer/opening/scene_look.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class LessonNumbers : public GlTest {
 protected:
  Errors errors_at(const std::string& lesson, size_t step, const std::vector<Assignment>& patch = {}) {
    Settings s = settings_at(load_lesson(lesson), step - 1);
    apply_patch(s, patch, "test");
    s.size = {320, 180};
    Lab lab(FeatureSet{});
    lab.open(s.scene);
    Bench bench(lab.renderer(), lab.cost(), lab.machine(), 1);
    bench.start(s, lab.gpu_scene(), {.times = false});
    while (!bench.step(true)) {
    }
    return bench.errors();
  }
};

TEST_F(LessonNumbers, WhatANormalCosts) {
  const char* kLesson = "what-does-a-normal-cost";
  const Errors bytes3 = errors_at(kLesson, 2), no_sign = errors_at(kLesson, 3), bytes2 = errors_at(kLesson, 4),
               oct12 = errors_at(kLesson, 5), bytes4 = errors_at(kLesson, 6);
  EXPECT_NEAR(*bytes3.normal_deg_max, 0.36, 0.02);
  EXPECT_NEAR(*bytes3.normal_deg_mean, 0.12, 0.01);
  EXPECT_NEAR(*no_sign.normal_deg_max, 62, 2);
  EXPECT_NEAR(*bytes2.normal_deg_mean, 0.28, 0.02);
  EXPECT_NEAR(*bytes2.over_1_255_display, 0.05, 0.01);
  EXPECT_NEAR(*bytes3.over_1_255_display, 0.014, 0.004);
  EXPECT_NEAR(*oct12.normal_deg_mean, 0.012, 0.001);
  EXPECT_EQ(*oct12.over_1_255_display, 0);
  EXPECT_NEAR(*bytes4.normal_deg_mean, 0.001, 0.0002);
}

TEST_F(LessonNumbers, WhereDepthPrecisionGoes) {
  const char* kLesson = "where-depth-precision-goes";
  const double fixed = *errors_at(kLesson, 3).position_mean, near = *errors_at(kLesson, 4).position_mean,
               floats = *errors_at(kLesson, 5).position_mean, reversed = *errors_at(kLesson, 6).position_mean,
               reversed_near = *errors_at(kLesson, 7).position_mean;
  EXPECT_NEAR(fixed, 0.1, 0.01);
  EXPECT_NEAR(near, 0.95, 0.1);
  EXPECT_NEAR(floats, 0.07, 0.01);
  EXPECT_NEAR(reversed, 0.0002, 0.0001);
  EXPECT_NEAR(reversed_near, 0.0002, 0.0001);
  EXPECT_GT(floats / reversed, 300) << "four hundred times less";
}

TEST_F(LessonNumbers, TheLectureOfTenMinutes) {
  const Errors culled = errors_at("ten-minutes", 6), twice = errors_at("ten-minutes", 7),
               bytes = errors_at("ten-minutes", 8), right = errors_at("ten-minutes", 9);
  EXPECT_GT(*culled.lost_pixels, 0.2 * 320 * 180);
  EXPECT_GT(*twice.doubled_pixels, 0.5 * 320 * 180);
  EXPECT_EQ(*twice.lost_pixels, 0);
  EXPECT_NEAR(*bytes.over_1_255_display, 0.47, 0.05) << "nearly half of the pixels";
  EXPECT_LT(*right.over_1_255_display, 0.0005) << "hardly a pixel";
  EXPECT_GT(*errors_at("ten-minutes", 8, {{"lights.only", 37}}).over_1_255_display, 0.1) << "one near light passes 1";
}

}  // namespace
}  // namespace gbl::test
