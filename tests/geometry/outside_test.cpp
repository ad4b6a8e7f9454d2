#include "hwffd/lattice/outside.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"

namespace hwffd {
namespace {

TEST(Outside, WeightsOfKeepAndClamp) {
  for (const double distance : {0.0, 1e-9, 1.0, 1e9}) {
    EXPECT_EQ(Outside::parse("keep").weight(distance), 0.0);
    EXPECT_EQ(Outside::parse("clamp").weight(distance), 1.0);
  }
  EXPECT_EQ(Outside::parse("keep").kind(), Outside::Kind::kKeep);
  EXPECT_EQ(Outside::parse("clamp").kind(), Outside::Kind::kClamp);
  EXPECT_EQ(Outside::parse("clamp").width(), 0.0);
}

TEST(Outside, FadeFallsSmoothlyFromOneToZero) {
  const Outside fade = Outside::parse("fade:2.5");
  EXPECT_EQ(fade.kind(), Outside::Kind::kFade);
  EXPECT_EQ(fade.width(), 2.5);
  EXPECT_EQ(fade.weight(0.0), 1.0);
  EXPECT_EQ(fade.weight(1.25), 0.5);
  EXPECT_EQ(fade.weight(2.5), 0.0);
  EXPECT_EQ(fade.weight(3.0), 0.0);
  double steepest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double drop = fade.weight(i * 0.0025) - fade.weight((i + 1) * 0.0025);
    EXPECT_GT(drop, 0.0) << i;
    steepest = std::max(steepest, drop / 0.0025);
  }
  EXPECT_NEAR(steepest, 1.5 / 2.5, 1e-5);
  // The slope is zero at both ends: C1 with the constant weights beyond.
  EXPECT_LT((1.0 - fade.weight(1e-6)) / 1e-6, 1e-5);
  EXPECT_LT(fade.weight(2.5 - 1e-6) / 1e-6, 1e-5);
}

TEST(Outside, RefusesTheRest) {
  const std::string accepted = "; accepted are keep, clamp and fade:WIDTH";
  for (const std::string text : {"", "fade", "Keep", "keep:1", "clamp:", "drop"}) {
    EXPECT_USAGE_ERROR(
        Outside::parse(text),
        std::string("outside '").append(text).append("' is unknown").append(accepted));
  }
  for (const std::string width : {"", "0", "-1", "nan", "inf", "1e999", "x", "1 ", "0x1"}) {
    const std::string message = message_of<UsageError>([&] { Outside::parse("fade:" + width); });
    expect_part(message, "outside 'fade:" + width + "': ");
    const std::string what = "' is not a finite number above 0";
    expect_part(message, std::string("'").append(width).append(what).append(accepted));
  }
}

}  // namespace
}  // namespace hwffd
