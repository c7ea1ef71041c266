#pragma once

#include "control/base/result.h"

#include <QObject>
#include <QString>

#include <optional>

namespace halbench::widgets {
class QuantityEdit;
}

namespace halbench::app {

/// Stands between a number field and what moves by it. A field whose text was no number inside its limits
/// shows the number before; the first motion after that is refused, so that nobody moves by a number that
/// was not typed and perhaps not seen.
class NumberCheck : public QObject {
    Q_OBJECT
public:
    explicit NumberCheck(widgets::QuantityEdit& field);

    /// What was typed, also before the field is left. Errors: InvalidInput with a text that is no number
    /// inside the limits; after that, unless such a text still stands there, the number that is shown.
    Result<double> take();

Q_SIGNALS:
    void refused(const QString& text, const QString& remedy); ///< on Enter, or when the field is left

private:
    Error words(const QString& text) const;

    widgets::QuantityEdit& m_field;
    std::optional<QString> m_refused;
};

} // namespace halbench::app
