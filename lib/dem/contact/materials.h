// Materials of one contact law, without its type.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only the sweep over contacts needs the type, and gets it by of(). A new law therefore recompiles few files.
#pragma once

#include <memory>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <vector>

#include "dem/contact/laws/resistance.h"

namespace soilweave::dem {

/// The part of a material that all laws have.
struct CommonMaterial {
  /// Friction angle, rad.
  double friction_angle = 0;
  /// Whether this friction angle applies in contacts with any other material.
  bool friction_decides = false;
  /// Resistance to rolling and to twisting.
  Resistance rolling, twisting;
  /// Modulus of the contacts' stiffness, Pa; set() ignores it.
  double modulus = 0;
};

/// Materials of one law by material_id, planes included. A copy has materials of its own.
class Materials {
 public:
  /// Holds no materials.
  Materials() = default;
  /// Takes the materials of a law.
  template <class Material>
  Materials(std::vector<Material> all) : held_(std::make_unique<HeldOf<Material>>(std::move(all))) {}
  Materials(const Materials& other) : held_(other.held_ ? other.held_->copy() : nullptr) {}
  Materials& operator=(const Materials& other) {
    if (this != &other) held_ = other.held_ ? other.held_->copy() : nullptr;
    return *this;
  }
  Materials(Materials&&) noexcept = default;
  Materials& operator=(Materials&&) noexcept = default;
  ~Materials() = default;

  /// Returns the name of the law, as in scenarios.
  std::string_view law() const { return held_ ? held_->law() : std::string_view(); }
  /// Returns the number of materials.
  std::size_t size() const { return held_ ? held_->size() : 0; }
  /// Returns the common part of material k.
  CommonMaterial at(std::size_t k) const { return held_->common(k); }
  /// Changes the common part of material k, its modulus excepted.
  void set(std::size_t k, const CommonMaterial& m) { held_->set(k, m); }

  /// Returns whether the materials are of this type. It compares the laws' names, because objects for eight lanes have
  /// their own type information (Makefile).
  template <class Material>
  bool are() const {
    return law() == Material::Law::name;
  }
  /// Returns the materials by their type. Throws std::bad_cast if the materials belong to another law.
  template <class Material>
  const std::vector<Material>& of() const {
    if (!are<Material>()) throw std::bad_cast();
    return static_cast<const HeldOf<Material>&>(*held_).all;
  }
  template <class Material>
  std::vector<Material>& of() {
    if (!are<Material>()) throw std::bad_cast();
    return static_cast<HeldOf<Material>&>(*held_).all;
  }

 private:
  /// Materials of any law.
  struct Held {
    virtual ~Held() = default;
    virtual std::unique_ptr<Held> copy() const = 0;
    virtual std::string_view law() const = 0;
    virtual std::size_t size() const = 0;
    virtual CommonMaterial common(std::size_t k) const = 0;
    virtual void set(std::size_t k, const CommonMaterial& m) = 0;
  };
  /// Materials of one law.
  template <class Material>
  struct HeldOf final : Held {
    explicit HeldOf(std::vector<Material> materials) : all(std::move(materials)) {}
    std::unique_ptr<Held> copy() const override { return std::make_unique<HeldOf>(all); }
    std::string_view law() const override { return Material::Law::name; }
    std::size_t size() const override { return all.size(); }
    CommonMaterial common(std::size_t k) const override {
      const Material& m = all[k];
      return {m.friction_angle, m.friction_decides, m.rolling, m.twisting, Material::Law::modulus(m)};
    }
    void set(std::size_t k, const CommonMaterial& c) override {
      Material& m = all[k];
      m.friction_angle = c.friction_angle, m.friction_decides = c.friction_decides;
      m.rolling = c.rolling, m.twisting = c.twisting;
    }
    std::vector<Material> all;
  };

  /// The materials; nullptr if there are none.
  std::unique_ptr<Held> held_;
};

}  // namespace soilweave::dem
