#pragma once

#include <QString>

#include <string>

namespace halbench::app {

/// A design method or a shipped preset as people read it ("pole placement"); what is not known, its own name.
/// The program and its files have the name ("pole-placement").
QString designTitle(const std::string& name);

} // namespace halbench::app
