// The engine gives the same bits on every processor, whatever its vector instructions: a digest of states is kept here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "dem/engine/simulation.h"
#include "files/provenance.h"
#include "support/assemblies.h"

namespace soilweave::dem {
namespace {

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

// Returns the SHA-256 of a sheared packing: grains, contacts and what the contacts remember.
std::string digest(const Model& model, int dimension) {
  const std::size_t grains = 150;
  Simulation simulation(support::packed(model, 1e5, grains, dimension), model, {});
  Mat3 gradient = Mat3::Zero();
  gradient.diagonal() = Vec3(0.05, -0.1, dimension == 3 ? 0.05 : 0);
  gradient(0, 1) = 0.02;
  simulation.set_velocity_gradient(gradient);
  for (int k = 0; k < 200; ++k) simulation.step();
  const io::Snapshot state = simulation.snapshot();
  std::string bytes;
  append(bytes, state.grains.position);
  append(bytes, state.grains.velocity);
  append(bytes, state.grains.angular_velocity);
  append(bytes, state.contacts.bodies);
  append(bytes, state.contacts.normal_force);
  append(bytes, state.contacts.shear_force);
  append(bytes, state.contacts.rolling_moment);
  return io::sha256(bytes);
}

// The digests were found on x86-64-v3. AVX-512, PORTABLE=1 and `make other-processor` have to give them, too. They
// change only with a change of the physics or of the order of sums, which its commit has to name.
TEST(Bits, AreTheSameOnEveryProcessor) {
  EXPECT_EQ(digest(support::sand(), 3), "f01e3ed168a7de62abb56076a68133321c37c3150e8e2dfc170a89841c9c552b");
  EXPECT_EQ(digest(support::linear_sand(), 3), "60aa71660be5dcc9f3b2f7ae45a3fc93fca6e0ff5f9f3817ca935ead678954c0");
  EXPECT_EQ(digest(support::sand(), 2), "e2a441a3e2d67df0fe05a70294d8e390956d570bd03253180a7a68e4501524a2");
}

}  // namespace
}  // namespace soilweave::dem
