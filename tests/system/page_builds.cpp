#include "page_builds.hpp"

#include <algorithm>
#include <iterator>

#include "Vpages_basic.h"
#include "Vpages_basic_plain.h"
#include "Vpages_cg1.h"
#include "Vpages_factored3.h"
#include "Vpages_four.h"
#include "Vpages_jacobian3.h"
#include "Vpages_lanes.h"
#include "Vpages_nested3.h"
#include "Vpages_one.h"
#include "Vpages_one8.h"
#include "Vpages_scan4.h"
#include "Vpages_tree8.h"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kPlain = model::kResidentFeature | model::kPagesFeature;
const PageBuild kBuilds[] = {
    {"cg1",
     "cg1-fx18-overlapped",
     {model::kAllFeatures | model::kPagesFeature | model::kFourthFeature | model::kMarksFeature, 16,
      4},
     make_page_core<Vpages_cg1>},
    {"basic",
     "basic-bfp32-overlapped",
     {kPlain | model::kInterleavedFeature, 32, 4},
     make_page_core<Vpages_basic>},
    {"basic_plain", "basic-fx18-overlapped", {kPlain, 16, 2}, make_page_core<Vpages_basic_plain>},
    {"tree8",
     "tree8-fx18-overlapped",
     {kPlain | model::kInterleavedFeature | model::kLargeFeature | model::kFourthFeature |
          model::kMarksFeature,
      64, 3},
     make_page_core<Vpages_tree8>},
    {"factored3",
     "factored3-fx18-overlapped",
     {kPlain | model::kFourthFeature | model::kMarksFeature, 8, 5},
     make_page_core<Vpages_factored3>},
    {"nested3",
     "nested3-fx18-overlapped",
     {model::kAllFeatures | model::kPagesFeature | model::kFourthFeature, 16, 3},
     make_page_core<Vpages_nested3>},
    {"jacobian3",
     "jacobian3-fx17-overlapped",
     {model::kAllFeatures | model::kPagesFeature | model::kFourthFeature, 16, 3},
     make_page_core<Vpages_jacobian3>},
    {"lanes",
     "jacobian3x3-fx17-overlapped",
     {model::kAllFeatures | model::kPagesFeature | model::kFourthFeature, 16, 2},
     make_page_core<Vpages_lanes>},
    {"scan4", "scan4-fx17-overlapped", {kPlain, 16, 3}, make_page_core<Vpages_scan4>},
    {"four", "cg1-fx18-overlapped", {kPlain, 4, 5}, make_page_core<Vpages_four>},
    {"one",
     "cg1-fx18-overlapped",
     {model::kAllFeatures | model::kPagesFeature | model::kFourthFeature, 16, 1},
     make_page_core<Vpages_one>},
    {"one8",
     "tree8-fx18-overlapped",
     {kPlain | model::kInterleavedFeature, 8, 1},
     make_page_core<Vpages_one8>},
};

}  // namespace

std::vector<PageBuild> page_builds(bool (*wanted)(const PageBuild&)) {
  std::vector<PageBuild> some;
  std::copy_if(std::begin(kBuilds), std::end(kBuilds), std::back_inserter(some), wanted);
  return some;
}

}  // namespace hwffd::test
