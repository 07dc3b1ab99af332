// The module engine, as a table of contents: from a scene to its motion.
//
//   Scene -> compile -> Model;  initial_state -> State;  settle;  drive(Model, State, options, observer)
#pragma once

#include "engine/accuracy.h"                // draft, standard, reference
#include "engine/collision/broad_phase.h"   // which pairs can meet
#include "engine/collision/manifold.h"      // where two shapes can touch
#include "engine/collision/separation.h"    // separating axes
#include "engine/contact/contact_points.h"  // gaps, slips and forces
#include "engine/contact/contact_set.h"     // pairs and points, kept up to date
#include "engine/contact/law.h"             // the contact law at a point
#include "engine/contact/stiffness.h"       // its stiffness and damping
#include "engine/drive.h"                   // time, step, health, output
#include "engine/dynamics.h"                // equations of motion
#include "engine/energy.h"                  // the energy ledger
#include "engine/fields/fields.h"           // gravitation, charges, drag
#include "engine/frame.h"                   // poses and velocities at one moment
#include "engine/integrators/table.h"       // how the motion is integrated
#include "engine/material.h"                // materials
#include "engine/model.h"                   // the compiled scene
#include "engine/modes.h"                   // small vibrations
#include "engine/motion.h"                  // prescribed motion of a terrain
#include "engine/scene.h"                   // the description
#include "engine/settle.h"                  // equilibrium under gravity
#include "engine/shape.h"                   // circles and convex polygons
#include "engine/stability.h"               // bound of the highest frequency
#include "engine/state.h"                   // what changes during a run
