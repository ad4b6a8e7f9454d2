// The calls that `make glapi` counts are those of the header, and each does what it should.

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "call_checks.hpp"
#include "context.hpp"

namespace hwffd::glapi {
namespace {

TEST(Calls, EachOfTheHeaderIsChecked) {
  std::ifstream file(HWFFD_GLFFD_H);
  std::stringstream text;
  text << file.rdbuf();
  const std::string header = text.str();
  const std::regex declaration(R"(\n[A-Za-z][^\n(]*?\*?\bhwffd_(glu?[A-Z]\w*)\()");
  std::set<std::string> declared;
  for (std::sregex_iterator it(header.begin(), header.end(), declaration), end; it != end; ++it) {
    declared.insert((*it)[1]);
  }
  std::set<std::string> checked;
  for (const CallCheck& check : call_checks()) {
    checked.insert(check.calls.begin(), check.calls.end());
  }
  EXPECT_EQ(declared.size(), 35U);
  EXPECT_EQ(checked, declared);
}

TEST(Calls, DoWhatTheyShould) {
  const Context context;
  for (const CallCheck& check : call_checks()) {
    EXPECT_EQ(error_of([&] { EXPECT_TRUE(check.passes()) << check.calls.front(); }), 0U)
        << check.calls.front();
  }
}

}  // namespace
}  // namespace hwffd::glapi
