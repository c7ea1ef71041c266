#pragma once

#include <QString>

#include <optional>

namespace halbench::widgets {

/// The hints of the layers below name options of the command line. In the window the same remedy is another
/// act: what to enter where, in the user's language. Nothing for hints that are true of both.
std::optional<QString> windowTerms(const QString& hint);

} // namespace halbench::widgets
