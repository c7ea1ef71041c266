#pragma once

#include "widgets/actuators/actuator_view.h"

#include <deque>
#include <functional>
#include <string>

namespace halbench::widgets {

/// The views that are built in, and those that tests add. Rows stay where they are.
const std::deque<ActuatorView>& actuatorViews();

/// Adds a view, or replaces the one of the same id.
void addActuatorView(ActuatorView view);

/// The first view all of whose needed roles `plays`; nullptr when there is none.
const ActuatorView* actuatorViewFor(const std::function<bool(const std::string& role)>& plays);

} // namespace halbench::widgets
