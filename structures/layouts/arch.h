// A circular arch of equal straight-sided voussoirs, laid dry between two abutments that belong to the
// ground.
//
//   joint j of N + 1, from the left:  angle  phi_j = pi/2 + e/2 - j e/N  from the x axis
//   voussoir j:  the quadrilateral of joints j - 1 and j between the radii r -+ t/2
//
//   r  radius of the centre line   m     t  ring_thickness  m     e  embrace_angle   rad     N  voussoirs
//
// The abutments rise by abutment_height above the ground to the lower ends of the springing joints; their
// upper faces are those joints. They do not deform and move with the ground. With an abutment height of 0 and
// an embrace angle of 180 degrees there are none: the arch springs from the ground.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

Layout arch();

}  // namespace dougong::structures
