#pragma once
#include "garden.hpp"
#include <passes/depth_normal.hpp>

namespace prelight {

// Bounds for formats that cannot keep the half-float bound: what the format's own error costs, found with the
// reference alone. The scene itself is changed by a small known amount, the reference renders it
// again, and the mean squared difference, scaled to the format's largest error, is added to what the
// half-float bound allows. To first order no pixel can be off by more, whichever way its error points.

/// The largest angle between a direction and what comes back from the encoding's real target, degrees.
double largest_angle(const passes::NormalEncodingInfo& encoding);

/// PSNR of a picture whose normals are all off by `degrees`: the squares of three pictures with all normals
/// turned about one axis each add up to those of an error in the worst direction.
Bound bound_for_normals(Garden& garden, const Shot& shot, double degrees);

/// PSNR of a picture whose depths are all off by `relative`: the surfaces are moved so along their rays,
/// and keep their normals.
Bound bound_for_depth(Garden& garden, const Shot& shot, double relative);

} // namespace prelight
