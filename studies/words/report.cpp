#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace hwffd::words {
namespace {

/// The shortest fixed-point word of a form whose error is at most `limit`; 0 if none is.
int shortest(const std::vector<Result>& results, const std::string& form, double Result::*error,
             double limit) {
  int width = 0;
  for (const Result& r : results) {
    const bool fits = r.fixed && r.form == form && r.*error <= limit;
    if (fits && (width == 0 || r.word_length < width)) width = r.word_length;
  }
  return width;
}

double binary32_error(const std::vector<Result>& results, const std::string& form,
                      const std::string& format, double Result::*error) {
  const auto found = std::find_if(results.begin(), results.end(), [&](const Result& r) {
    return r.form == form && r.format == format;
  });
  return found == results.end() ? 0 : (*found).*error;
}

}  // namespace

std::string table(const std::vector<Result>& results) {
  std::string text =
      fmt::format("{:<9} {:<22} {:>5} {:>10} {:>10} {:>10} {:>10} {:>9}\n", "form", "format",
                  "bits", "max error", "rms error", "bound", "bound/max", "vertices");
  for (const Result& r : results) {
    text += fmt::format("{:<9} {:<22} {:>5} {:>10.2e} {:>10.2e} {:>10.2e} {:>10.1f} {:>9}\n",
                        r.form, r.format, r.word_length, r.max_error, r.rms_error, r.bound,
                        r.bound / r.max_error, r.vertices);
  }
  return text;
}

std::string answer(const std::vector<Result>& results) {
  std::set<std::string> forms;
  for (const Result& r : results) forms.insert(r.form);
  std::string text;
  for (const std::string& form : forms) {
    const auto at_most = [&](double Result::*error, double limit) {
      return shortest(results, form, error, limit);
    };
    const auto as_binary32 = [&](const char* format, double Result::*error) {
      return at_most(error, binary32_error(results, form, format, error));
    };
    text += fmt::format(
        "{}: as accurate as binary32 in sequence: {} bits by max, {} by rms; as its tree: {} and "
        "{}\n"
        "{}: within half a pixel of {} ({:.2e}): {} bits measured, {} bits proved\n",
        form, as_binary32("fp32-sequential", &Result::max_error),
        as_binary32("fp32-sequential", &Result::rms_error),
        as_binary32("fp32-tree", &Result::max_error), as_binary32("fp32-tree", &Result::rms_error),
        form, kPictureWidth, kHalfPixel, at_most(&Result::max_error, kHalfPixel),
        at_most(&Result::bound, kHalfPixel));
  }
  return text;
}

std::string json_report(const std::vector<Result>& results) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Result& r : results) {
    rows.push_back({{"form", r.form},
                    {"format", r.format},
                    {"word_length", r.word_length},
                    {"max_error", r.max_error},
                    {"rms_error", r.rms_error},
                    {"bound", r.bound},
                    {"vertices", r.vertices}});
  }
  return nlohmann::ordered_json{{"rows", std::move(rows)}}.dump(2) + "\n";
}

std::string faults(const std::vector<Result>& results) {
  std::string text;
  for (const Result& r : results) {
    if (r.vertices > 0 && r.max_error <= r.bound) continue;
    text += fmt::format("{} {}: error {:.3e} over {} vertices, {:.3e} is proved\n", r.form,
                        r.format, r.max_error, r.vertices, r.bound);
  }
  return text;
}

}  // namespace hwffd::words
