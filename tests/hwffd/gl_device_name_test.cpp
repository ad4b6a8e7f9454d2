// The device of an OpenGL program: its name in one word, and in the environment.
#include <gtest/gtest.h>
#include <stdlib.h>

#include "device_name.hpp"
#include "errors.hpp"

namespace hwffd::gl {
namespace {

std::string parts_of(const DeviceChoice& choice) {
  return choice.device + "|" + choice.org + "|" + choice.format;
}

TEST(GlDeviceName, HasUpToThreeParts) {
  EXPECT_EQ(parts_of(parse_device("reference")), "reference||");
  EXPECT_EQ(parts_of(parse_device("rtl:factored/3")), "rtl|factored/3|");
  EXPECT_EQ(parts_of(parse_device("rtl:parallel:fx18")), "rtl|parallel|fx18");
  for (const std::string bad :
       {"", ":basic", "rtl:", "rtl::fx18", "rtl:basic:", "rtl:basic:fx18:", "rtl:basic:fx18:x"}) {
    EXPECT_USAGE_ERROR(parse_device(bad),
                       "device '" + bad + "': write it as rtl or as rtl:parallel:fx18");
  }
}

TEST(GlDeviceName, OfTheEnvironmentIsTheModelUnlessItSaysOtherwise) {
  ::unsetenv("HWFFD_DEVICE");
  EXPECT_EQ(parts_of(device_of_environment()), "model||");
  ::setenv("HWFFD_DEVICE", "", 1);
  EXPECT_EQ(parts_of(device_of_environment()), "model||");
  ::setenv("HWFFD_DEVICE", "rtl:basic", 1);
  EXPECT_EQ(parts_of(device_of_environment()), "rtl|basic|");
  ::setenv("HWFFD_DEVICE", "rtl:", 1);
  EXPECT_USAGE_ERROR(device_of_environment(),
                     "HWFFD_DEVICE: device 'rtl:': write it as rtl or as rtl:parallel:fx18");
  ::unsetenv("HWFFD_DEVICE");
}

}  // namespace
}  // namespace hwffd::gl
