// What vectors and turns are in space, and in the plane of disks, where a vector has two parts and a turn has one. The
// same formulas serve both (core/v2.h, core/v3.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/v2.h"
#include "core/v3.h"

namespace soilweave::dem {

struct Spatial {
  template <class T>
  using Vector = V3<T>;
  template <class T>
  using Turn = V3<T>;
  static constexpr bool twists = true;  // grains can turn about the normal of a contact
};

struct Planar {
  template <class T>
  using Vector = V2<T>;
  template <class T>
  using Turn = T;
  static constexpr bool twists = false;
};

template <class T, class Space>
using Vector = typename Space::template Vector<T>;
template <class T, class Space>
using Turn = typename Space::template Turn<T>;

}  // namespace soilweave::dem
