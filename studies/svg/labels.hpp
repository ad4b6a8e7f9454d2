#pragma once

#include <string>
#include <vector>

namespace hwffd::svg {

/// Names beside the marks of a chart, in 10 pixels, where they cover neither marks nor each other.
class Labels {
 public:
  /// A mark with its centre here, which no label may cover. All marks come before the labels.
  void keep_free(double x, double y);
  /// The same of a line between two points.
  void keep_free(double x1, double y1, double x2, double y2);

  /// A label of a mark as an element of SVG: above or below the mark or beside it, at the first
  /// place that is free, else at the least covered one.
  std::string beside(double x, double y, const std::string& words, const std::string& colour,
                     bool above);

 private:
  struct Box {
    double left, top, right, bottom;
  };
  double covered(const Box& box) const;

  std::vector<Box> taken_;
};

}  // namespace hwffd::svg
