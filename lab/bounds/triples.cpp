#include "triples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hwffd::certified {
namespace {

/// What an axis is off: its functions, the largest sum of their magnitudes, and that of their
/// derivatives' magnitudes.
struct Functions {
  Four (*at)(double);
  double size;
  double steepness;
};
/// Sum |B_l'| is 1 + 2x - 2x^2.
constexpr Functions kBsplines{bounds::bspline, 1, 1.5};
/// Of half the derivatives, sum |B_l''| / 2 is largest at an end.
constexpr Functions kSlopes{half_slopes, 0.75, 2};

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

void complete(Node& node, const Functions& functions) {
  const double x = (node.box.low_x + node.box.high_x) / 2;
  const double half = (node.box.high_x - node.box.low_x) / 2;
  node.exact = functions.at(x);
  node.reach = functions.steepness * half;
  for (int l = 0; l < 4; ++l) {
    node.error[l] = (node.box.low[l] + node.box.high[l]) / 2;
    node.spread += (node.box.high[l] - node.box.low[l]) / 2;
    node.size += std::max(std::abs(node.box.low[l]), std::abs(node.box.high[l]));
  }
}

class Tree {
 public:
  Tree(std::vector<ErrorBox> boxes, const Functions& functions)
      : functions_(functions), boxes_(std::move(boxes)) {
    if (boxes_.empty()) throw std::invalid_argument("no coordinates to bound");
    nodes_.reserve(2 * boxes_.size());
    build(0, boxes_.size());
  }
  int size() const { return static_cast<int>(nodes_.size()); }
  const Node& operator[](int n) const { return nodes_[n]; }
  /// The largest sum of magnitudes of functions.
  double functions() const { return functions_.size; }

 private:
  int build(std::size_t first, std::size_t last) {
    const int number = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    Node node;
    node.first = first;
    node.last = last;
    for (std::size_t i = first; i < last; ++i) node.box.add(boxes_[i]);
    complete(node, functions_);
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

  Functions functions_;
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

class Search {
 public:
  /// @param trees  of the axes, which may be the same
  Search(const std::array<const Tree*, 3>& trees, double tolerance)
      : trees_(trees), tolerance_(tolerance) {}

  TripleBound run() {
    guess();
    visit({0, 0, 0});
    result_.bound = std::max(result_.bound, result_.reached * (1 + tolerance_));
    add_what_is_left_out();
    return result_;
  }

 private:
  using Nodes = std::array<const Node*, 3>;

  const Tree& tree(int axis) const { return *trees_[axis % 3]; }
  /// The largest sums of magnitudes of functions of the two other axes.
  double others(int axis) const { return tree(axis + 1).functions() * tree(axis + 2).functions(); }

  /// So that little is looked at in vain: from the largest errors of each axis on, one axis after
  /// the other takes its best box, and where axes are alike, each box three times.
  void guess() {
    Nodes best{};
    for (int axis = 0; axis < 3; ++axis) {
      for (int n = 0; n < tree(axis).size(); ++n) {
        const Node& node = tree(axis)[n];
        if (node.left < 0 && (!best[axis] || node.size > best[axis]->size)) best[axis] = &node;
      }
    }
    for (int turn = 0; turn < 2 * 3; ++turn) {
      const int axis = turn % 3;
      for (int n = 0; n < tree(axis).size(); ++n) {
        Nodes probe = best;
        probe[axis] = &tree(axis)[n];
        if (probe[axis]->left < 0 && raise(at_middles(*probe[0], *probe[1], *probe[2]))) {
          best = probe;
        }
      }
    }
    if (trees_[0] != trees_[1]) return;
    for (int n = 0; n < tree(0).size(); ++n) {
      const Node& node = tree(0)[n];
      if (node.left < 0) raise(at_middles(node, node, node));
    }
  }

  void visit(const std::array<int, 3>& number) {
    Nodes node;
    for (int axis = 0; axis < 3; ++axis) node[axis] = &tree(axis)[number[axis]];
    // The form does not change where axes that are alike change places: one order will do.
    for (int axis = 0; axis < 2; ++axis) {
      if (trees_[axis] == trees_[axis + 1] && node[axis]->last <= node[axis + 1]->first) return;
    }
    // Errors of an axis alone come first, since they cost nothing.
    double most = 0;
    for (int axis = 0; axis < 3; ++axis) most += node[axis]->size * others(axis);
    if (most <= enough()) return;
    ++result_.steps;
    const double middle = at_middles(*node[0], *node[1], *node[2]);
    const std::array<double, 3> more = slack(node);
    const double bound = std::min(most, middle + more[0] + more[1] + more[2]);
    if (bound <= enough()) return;
    int split = -1;
    for (int axis = 0; axis < 3; ++axis) {
      if (node[axis]->left >= 0 && (split < 0 || more[axis] > more[split])) split = axis;
    }
    if (split < 0) {  // single boxes
      raise(middle);
      result_.bound = std::max(result_.bound, bound);
      return;
    }
    for (const int half : {node[split]->left, node[split]->right}) {
      std::array<int, 3> halved = number;
      halved[split] = half;
      visit(halved);
    }
  }

  /// What of the sum may be larger elsewhere in the boxes than at the middles, axis by axis.
  std::array<double, 3> slack(const Nodes& node) const {
    std::array<double, 3> more{};
    for (int axis = 0; axis < 3; ++axis) {
      const Node& next = *node[(axis + 1) % 3];
      const Node& last = *node[(axis + 2) % 3];
      more[axis] = node[axis]->spread * others(axis) +
                   node[axis]->reach * (next.size * tree(axis + 2).functions() +
                                        last.size * tree(axis + 1).functions());
    }
    return more;
  }

  /// The second and third order, from the largest errors of the axes.
  void add_what_is_left_out() {
    double all = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double next = tree(axis + 1)[0].size;
      result_.bound += next * tree(axis + 2)[0].size * tree(axis).functions();
      all *= next;
    }
    result_.bound += all;
  }

  double enough() const { return std::max(result_.bound, result_.reached * (1 + tolerance_)); }
  bool raise(double reached) {
    const bool higher = reached > result_.reached;
    if (higher) result_.reached = reached;
    return higher;
  }

  std::array<const Tree*, 3> trees_;
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
  const Tree tree(std::move(boxes), kBsplines);
  return Search({&tree, &tree, &tree}, tolerance).run();
}

TripleBound bound_triples_with_slopes(std::vector<ErrorBox> slopes, std::vector<ErrorBox> boxes,
                                      double tolerance) {
  const Tree of_slopes(std::move(slopes), kSlopes);
  const Tree tree(std::move(boxes), kBsplines);
  return Search({&of_slopes, &tree, &tree}, tolerance).run();
}

}  // namespace hwffd::certified
