#include "triples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hwffd::certified {
namespace {

/// A set of boxes, those from `first` to `last`, split along its longest side.
struct Node {
  ErrorBox box;
  std::size_t first = 0;
  std::size_t last = 0;
  int left = -1;  // of its halves; -1 where it is a single box
  int right = -1;
  // Of the middle of the box:
  Four exact{};
  Four error{};
  double size = 0;    // the largest sum of magnitudes of errors in the box
  double spread = 0;  // sum of half the sides of errors
  double reach = 0;   // how far B may be off, as a sum of magnitudes
};

void complete(Node& node) {
  const double x = (node.box.low_x + node.box.high_x) / 2;
  const double half = (node.box.high_x - node.box.low_x) / 2;
  node.exact = bounds::bspline(x);
  // sum |B_l'| is 1 + 2x - 2x^2, at most 3/2.
  node.reach = 1.5 * half;
  for (int l = 0; l < 4; ++l) {
    node.error[l] = (node.box.low[l] + node.box.high[l]) / 2;
    node.spread += (node.box.high[l] - node.box.low[l]) / 2;
    node.size += std::max(std::abs(node.box.low[l]), std::abs(node.box.high[l]));
  }
}

class Tree {
 public:
  explicit Tree(std::vector<ErrorBox> boxes) : boxes_(std::move(boxes)) {
    if (boxes_.empty()) throw std::invalid_argument("no coordinates to bound");
    nodes_.reserve(2 * boxes_.size());
    build(0, boxes_.size());
  }
  int size() const { return static_cast<int>(nodes_.size()); }
  const Node& operator[](int n) const { return nodes_[n]; }

 private:
  int build(std::size_t first, std::size_t last) {
    const int number = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    Node node;
    node.first = first;
    node.last = last;
    for (std::size_t i = first; i < last; ++i) node.box.add(boxes_[i]);
    complete(node);
    if (last - first > 1) {
      const int side = longest(node.box);
      const std::size_t middle = (first + last) / 2;
      std::nth_element(
          boxes_.begin() + static_cast<std::ptrdiff_t>(first),
          boxes_.begin() + static_cast<std::ptrdiff_t>(middle),
          boxes_.begin() + static_cast<std::ptrdiff_t>(last),
          [side](const ErrorBox& a, const ErrorBox& b) { return place(a, side) < place(b, side); });
      node.left = build(first, middle);
      node.right = build(middle, last);
    }
    nodes_[number] = node;
    return number;
  }
  static double place(const ErrorBox& box, int side) {
    return side == 4 ? box.low_x + box.high_x : box.low[side] + box.high[side];
  }
  /// 0 to 3: an error; 4: the coordinate, whose part in the slack is its length times errors.
  static int longest(const ErrorBox& box) {
    int side = 4;
    double length = 0;
    double size = 0;
    for (int l = 0; l < 4; ++l) size += std::max(std::abs(box.low[l]), std::abs(box.high[l]));
    length = (box.high_x - box.low_x) * 3 * size;
    for (int l = 0; l < 4; ++l) {
      if (box.high[l] - box.low[l] > length) {
        length = box.high[l] - box.low[l];
        side = l;
      }
    }
    return side;
  }

  std::vector<ErrorBox> boxes_;
  std::vector<Node> nodes_;
};

/// The sum of 64 errors to first order, at the middles.
double at_middles(const Node& s, const Node& t, const Node& u) {
  double sum = 0;
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      const double pair = s.exact[l] * t.exact[m];
      const double error = s.error[l] * t.exact[m] + s.exact[l] * t.error[m];
      for (int n = 0; n < 4; ++n) sum += std::abs(error * u.exact[n] + pair * u.error[n]);
    }
  }
  return sum;
}

/// What of that may be larger elsewhere in the boxes, axis by axis.
std::array<double, 3> slack(const Node& s, const Node& t, const Node& u) {
  return {s.spread + s.reach * (t.size + u.size), t.spread + t.reach * (s.size + u.size),
          u.spread + u.reach * (s.size + t.size)};
}

class Search {
 public:
  Search(const Tree& tree, double tolerance) : tree_(tree), tolerance_(tolerance) {}

  TripleBound run() {
    // A first guess, so that little is looked at in vain: each box three times.
    for (int n = 0; n < tree_.size(); ++n) {
      if (tree_[n].left < 0) raise(at_middles(tree_[n], tree_[n], tree_[n]));
    }
    visit(0, 0, 0);
    result_.bound = std::max(result_.bound, result_.reached * (1 + tolerance_));
    return result_;
  }

 private:
  void visit(int i, int j, int k) {
    const std::array<const Node*, 3> node{&tree_[i], &tree_[j], &tree_[k]};
    // The form does not change where axes change places: one order will do.
    if (node[0]->last <= node[1]->first || node[1]->last <= node[2]->first) return;
    // Errors of an axis alone come first, since they cost nothing.
    const double most = node[0]->size + node[1]->size + node[2]->size;
    if (most <= enough()) return;
    ++result_.steps;
    const double middle = at_middles(*node[0], *node[1], *node[2]);
    const std::array<double, 3> more = slack(*node[0], *node[1], *node[2]);
    const double bound = std::min(most, middle + more[0] + more[1] + more[2]);
    if (bound <= enough()) return;
    std::array<int, 3> number{i, j, k};
    int axis = -1;
    for (int a = 0; a < 3; ++a) {
      if (node[a]->left >= 0 && (axis < 0 || more[a] > more[axis])) axis = a;
    }
    if (axis < 0) {  // single boxes
      raise(middle);
      result_.bound = std::max(result_.bound, bound);
      return;
    }
    for (const int half : {node[axis]->left, node[axis]->right}) {
      number[axis] = half;
      visit(number[0], number[1], number[2]);
    }
  }

  double enough() const { return std::max(result_.bound, result_.reached * (1 + tolerance_)); }
  void raise(double reached) { result_.reached = std::max(result_.reached, reached); }

  const Tree& tree_;
  double tolerance_;
  TripleBound result_;
};

}  // namespace

void ErrorBox::add(double x, const Four& e) {
  ErrorBox point;
  point.low_x = point.high_x = x;
  point.low = point.high = e;
  add(point);
}

void ErrorBox::add(const ErrorBox& other) {
  if (empty()) {
    *this = other;
    return;
  }
  low_x = std::min(low_x, other.low_x);
  high_x = std::max(high_x, other.high_x);
  for (int l = 0; l < 4; ++l) {
    low[l] = std::min(low[l], other.low[l]);
    high[l] = std::max(high[l], other.high[l]);
  }
}

TripleBound bound_triples(std::vector<ErrorBox> boxes, double tolerance) {
  const Tree tree(std::move(boxes));
  TripleBound result = Search(tree, tolerance).run();
  const double e = tree[0].size;
  double largest = 0;
  // The second and third order, from the largest error of one axis.
  for (int l = 0; l < 4; ++l) {
    largest += std::max(std::abs(tree[0].box.low[l]), std::abs(tree[0].box.high[l]));
  }
  result.bound += 3 * e * largest + e * e * e;
  return result;
}

}  // namespace hwffd::certified
