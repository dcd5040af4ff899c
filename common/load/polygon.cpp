// Ear clipping (Meisters, "Polygons have ears", 1975): a convex corner whose triangle holds no
// other corner is cut off, until a triangle is left. tinyobjloader 2.0's, for one, covers a hexagon
// with a notch more than twice.
#include "common/load/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace raylab {
namespace {

struct Point {
    double x = 0, y = 0;
    bool operator==(const Point&) const = default;
};

// Twice the area of a, b, c; above 0: a left turn.
double turn(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The polygon seen along the axis that it faces most, from the side from which it turns left. Its
// normal is Newell's sum of cross products, which is twice the area for any polygon in a plane.
std::vector<Point> flattened(const std::vector<DVec3>& corners) {
    DVec3 normal(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    const DVec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    std::vector<Point> points;
    for (const DVec3& p : corners)
        points.push_back(normal[axis] >= 0 ? Point{p[first], p[second]}
                                           : Point{p[second], p[first]});
    return points;
}

class EarClipping {
  public:
    explicit EarClipping(std::vector<Point> points)
        : points_(std::move(points)), before_(points_.size()), after_(points_.size()),
          gone_(points_.size()) {
        const int n = int(points_.size());
        for (int i = 0; i < n; ++i) {
            before_[i] = (i + n - 1) % n;
            after_[i] = (i + 1) % n;
        }
        for (int i = 0; i < n; ++i)
            if (turn_at(i) <= 0) reflex_.push_back(i);
    }

    std::vector<std::array<int, 3>> triangles() {
        int left = int(points_.size()), tried = 0;
        for (int i = 0; left > 3;) {
            // If no corner of a whole round is an ear, the polygon crosses itself or is flat: cut
            // any corner.
            if (is_ear(i) || tried >= left || tests_left_ < 0) {
                const int next = after_[after_[i]]; // not the neighbour: fans make slivers
                cut(i);
                --left;
                tried = 0;
                i = gone_[next] ? after_[i] : next;
            } else {
                ++tried;
                i = after_[i];
            }
            last_ = i;
        }
        triangles_.push_back({before_[last_], last_, after_[last_]});
        return std::move(triangles_);
    }

  private:
    double turn_at(int i) const {
        return turn(points_[before_[i]], points_[i], points_[after_[i]]);
    }

    bool is_ear(int i) {
        if (!(turn_at(i) > 0) || tests_left_ < 0) return false;
        tests_left_ -= std::int64_t(reflex_.size());
        const Point a = points_[before_[i]], b = points_[i], c = points_[after_[i]];
        // Only corners that are not convex can be the first that lies inside. A corner at the same
        // place as one of the ear's does not count: a bridge to a hole passes its two corners
        // twice.
        return std::none_of(reflex_.begin(), reflex_.end(), [&](int other) {
            const Point p = points_[other];
            return !(p == a) && !(p == b) && !(p == c) && turn(a, b, p) >= 0 &&
                   turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    void cut(int i) {
        const int a = before_[i], c = after_[i];
        triangles_.push_back({a, i, c});
        after_[a] = c;
        before_[c] = a;
        gone_[i] = true;
        std::erase_if(reflex_, [&](int other) {
            return other == i || ((other == a || other == c) && turn_at(other) > 0);
        });
    }

    std::vector<Point> points_;
    std::vector<int> before_, after_, reflex_;
    std::vector<char> gone_;
    int last_ = 0;
    // About one second of work. A polygon that crosses itself takes cubic time; when no tests are
    // left, the rest of it is cut without tests.
    std::int64_t tests_left_ = std::int64_t(1) << 28;
    std::vector<std::array<int, 3>> triangles_;
};

std::vector<std::array<int, 3>> cut_quad(const std::vector<DVec3>& corners) {
    const auto square = [](DVec3 v) { return dot(v, v); };
    const std::vector<Point> p = flattened(corners);
    const auto inside = [&](int from, int to) { // the others lie on two sides of the diagonal
        const int left = (from + 3) % 4, right = (from + 1) % 4;
        return turn(p[from], p[to], p[left]) > 0 && turn(p[from], p[to], p[right]) < 0;
    };
    const bool shorter = square(corners[2] - corners[0]) < square(corners[3] - corners[1]);
    if (inside(0, 2) && (shorter || !inside(1, 3))) return {{0, 1, 2}, {0, 2, 3}};
    return {{0, 1, 3}, {1, 2, 3}};
}

} // namespace

std::vector<std::array<int, 3>> cut_polygon(const std::vector<DVec3>& corners) {
    if (corners.size() == 3) return {{0, 1, 2}};
    if (corners.size() == 4) return cut_quad(corners);
    return EarClipping(flattened(corners)).triangles();
}

} // namespace raylab
