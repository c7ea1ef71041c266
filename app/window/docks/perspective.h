#pragma once

#include <QString>

#include <optional>

namespace halbench::app {

/// The five tasks that the window arranges its panels for.
enum class Perspective { Monitor, Identify, Tune, Record, Field };

inline constexpr Perspective AllPerspectives[] = {Perspective::Monitor, Perspective::Identify,
                                                  Perspective::Tune, Perspective::Record, Perspective::Field};

/// As the user reads it.
QString perspectiveTitle(Perspective perspective);
/// As files and preferences name it; stable.
QString perspectiveId(Perspective perspective);
/// Nothing for a name that is none.
std::optional<Perspective> perspectiveOf(const QString& id);

/// Monitors beside the first one, closed until the user opens them; a project keeps their plots by this.
inline constexpr const char* FurtherMonitors[] = {"monitor2", "monitor3"};

} // namespace halbench::app
