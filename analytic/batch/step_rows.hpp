#pragma once

#include "analytic/polynomials/polynomial.hpp"

namespace rockstack {

/// Lanes of a batch: as many as the widest instruction set computes at once, and a multiple of all others.
inline constexpr std::size_t batch_lanes = 8;

/// A number of each lane.
struct alignas(64) LaneRow {
  std::array<double, batch_lanes> lanes{};

  double& operator[](std::size_t lane) { return lanes[lane]; }
  double operator[](std::size_t lane) const { return lanes[lane]; }
};

/// A coefficient of each lane, for every order.
using CoefficientRows = std::array<LaneRow, max_terms<double>>;

/// One step of stacks of N blocks, lane by lane: what it starts from, and what comes out. Numbers are those
/// of the structures that they are named for; truth is 1 and 0.
template <std::size_t N>
struct StepRows {
  template <class Part>
  using PerBlock = std::array<Part, N>;

  bool linear = false;  ///< of all lanes
  bool forces = false;  ///< of all lanes: whether forces are asked for
  LaneRow busy;         ///< whether there is a step to make
  // of a scene
  LaneRow tolerance, rate, rounding;
  PerBlock<LaneRow> half_width, half_height, mass, inertia, centre_x, centre_y;  ///< of the stack
  PerBlock<LaneRow> toppling;                                                    ///< angle, rad
  PerBlock<LaneRow> face;  ///< whether forces are measured along the upper block's face
  // of a pattern
  PerBlock<LaneRow> side;     ///< sign of the contact
  PerBlock<LaneRow> watched;  ///< whether a closed interface may open
  LaneRow clear;              ///< whether there are no ties
  // of what is known
  PerBlock<LaneRow> least_normal, friction;
  // of the step
  LaneRow length, body_force_terms;  ///< s; terms of the body force
  CoefficientRows body_force_x, body_force_y;

  // of the record that a lane walks along, if it does
  std::array<const double*, batch_lanes> samples{};
  LaneRow interval, constant, last;    ///< as in GroundPieces::Record
  LaneRow gravity, negligible_change;  ///< m/s²
  LaneRow sample;                      ///< at which the piece starts
  LaneRow remaining, longest;          ///< of the piece, and of a step, s
  LaneRow walked;                      ///< whether the rows are those of the next step already
  LaneRow pieces;                      ///< that were walked along unattended

  // where the step starts from and, where it is plain or lands, has led
  PerBlock<LaneRow> angle, velocity, peak;
  PerBlock<LaneRow>
      opening;  ///< largest relative angle so far, rad; of the lowest interface its block's peak

  // what comes out
  LaneRow plain;            ///< whether nothing happens in the step, and nothing is to be recorded but peaks
  LaneRow lands;            ///< whether one interface closes, and nothing else happens
  LaneRow silent;           ///< then: whether nothing is to be recorded
  LaneRow landing, lander;  ///< where: s of the step, and the interface, from 0
  LaneRow foreseen;         ///< whether it is known what follows the impact: these, as in PredictedImpact
  PerBlock<LaneRow> cosine, sine, rotation, centre_speed_x, centre_speed_y;
  PerBlock<LaneRow> after, negligible, impulse_normal, impulse_tangential, impulse_moment;
  LaneRow orders;           ///< of the series
  LaneRow excess;           ///< how many times the tolerance is left out, 0 where none
  PerBlock<LaneRow> stays;  ///< whether an open interface stays open, or a watched one closed
  PerBlock<LaneRow>
      upright;  ///< whether a block neither topples, nor leans more or comes further off than before
  PerBlock<LaneRow> borne;  ///< whether an interface demands no more than before
  /// Coefficients of the dense output, in lanes whose step is neither plain nor lands silently.
  PerBlock<CoefficientRows> angles, right, left, normal, tangential;
};

/// The steps of one to three blocks by one instruction set.
struct StepKernels {
  void (*one_block)(StepRows<1>&);
  void (*two_blocks)(StepRows<2>&);
  void (*three_blocks)(StepRows<3>&);
};

extern const StepKernels sse2_kernels, avx2_kernels, avx512_kernels;

}  // namespace rockstack
