// SPDX-License-Identifier: BSD-3-Clause
// What a snapshot shows of the lattice.
#include "base/thinning.hpp"
#include "coupling/spread.hpp"
#include "fluid/observe.hpp"
#include "parallel/root_gather.hpp"
#include "run/coupled_simulation.hpp"

namespace rouleau {

template <class Real>
void CoupledSimulation<Real>::find_membrane_forces() {
  comm_.all_agree([&] {
    find_stencils(cells_, stencils_);
    sum_membrane_forces({});
    clear_touched(stencils_, fluid_.g);
    spread(cells_.F, stencils_, fluid_.g);
  });
}

template <class Real>
LatticePicture CoupledSimulation<Real>::take_picture(int stride) {
  LatticePicture own;
  const Vec3 body_force(driving_.force, 0, 0);
  each_thinned_node(fluid_.block, stride, [&](int i, int j, int k) {
    const NodeFlow flow = flow_at(fluid_, body_force, {i, j, k});
    own.rho_1.push_back(static_cast<float>(flow.rho_1));
    own.inside.push_back(flags_(i, j, k));
    for (std::size_t a = 0; a < 3; ++a) {
      own.velocity.push_back(static_cast<float>(flow.u[static_cast<Eigen::Index>(a)]));
      own.force.push_back(static_cast<float>(fluid_.g[a](i, j, k)));
    }
  });

  const Lattice lattice{thinned(fluid_.lattice.size, stride), fluid_.lattice.periodic};
  const RootGather root(comm_, lattice, thinned(fluid_.block, stride));
  return {lattice.size, root.gather(own.velocity, 3), root.gather(own.rho_1, 1), root.gather(own.force, 3),
          root.gather(own.inside, 1)};
}

template void CoupledSimulation<float>::find_membrane_forces();
template void CoupledSimulation<double>::find_membrane_forces();
template LatticePicture CoupledSimulation<float>::take_picture(int);
template LatticePicture CoupledSimulation<double>::take_picture(int);

}  // namespace rouleau
