// Ballistic deposition: where a disk falling straight down first touches something. [Meakin 1987]
#pragma once

#include <optional>
#include <vector>

#include "core/world/world.h"

namespace quicksand {

struct Landing {
  Vec2 centre{0, 0};  // of the falling disk when it touches [d]
  int touched = -1;   // the body that it touches
};

// What a disk falling straight down may land on, sorted into vertical strips: a landing looks at its own
// strips only. Of the world, whose disks must not move meanwhile; those that are added must be told of.
class LandingSite {
 public:
  explicit LandingSite(const World& world);
  void add(int disk);

  // A disk of this radius falling from above along the vertical through x lands on the highest disk in
  // its way, or on a floor (a wall whose normal points up); nothing if there is neither.
  //
  // With a capture radius [d] the first body whose surface comes this close to the disk's own draws it in
  // along the line of centres. No third body is nearer than that, so none is in the way but a wall that
  // is no floor; where one is, the disk goes on to its first touch.
  std::optional<Landing> land(double x, double radius, double capture = 0) const;

 private:
  struct Entry {
    int disk;
    int next;  // of the strip, or -1
  };
  std::optional<Landing> first_met(double x, double radius, double capture) const;
  // visit(strip) for the strips within `reach` of x; they repeat with the number of strips.
  template <class Visit>
  void visit_strips(double x, double reach, Visit visit) const;

  const World& world_;
  double strip_ = 1;        // width [d]
  std::vector<int> first_;  // (strips) entry, or -1
  std::vector<Entry> entries_;
  std::vector<int> wide_;  // disks that would be in too many strips
};

}  // namespace quicksand
