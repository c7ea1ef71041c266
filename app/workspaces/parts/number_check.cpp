#include "app/workspaces/parts/number_check.h"

#include "widgets/controls/quantity_edit.h"
#include "widgets/language/phrasebook.h"

#include <QLineEdit>

#include <utility>

namespace halbench::app {

NumberCheck::NumberCheck(widgets::QuantityEdit& field) : QObject(&field), m_field(field) {
    connect(&field, &widgets::QuantityEdit::refused, this, [this](const QString& text) {
        m_refused = text;
        const Error error = words(text);
        Q_EMIT refused(widgets::inWords(error.message), widgets::inWords(error.hint));
    });
    connect(&field, &widgets::QuantityEdit::edited, this, [this] { m_refused.reset(); });
    connect(field.findChild<QLineEdit*>(), &QLineEdit::textEdited, this, [this] { m_refused.reset(); });
}

Result<double> NumberCheck::take() {
    if (!m_field.hasAcceptableInput()) {
        return failure(words(m_field.text()));
    }
    if (const auto refusedText = std::exchange(m_refused, std::nullopt)) {
        return failure(words(*refusedText));
    }
    m_field.interpretText();
    return m_field.value();
}

Error NumberCheck::words(const QString& text) const {
    QString remedy = m_field.problemOf(text);
    if (m_field.hasAcceptableInput()) {
        remedy += QLatin1Char(' ') + tr("Reset to %1.").arg(m_field.text());
    }
    return {ErrorCode::InvalidInput,
            tr("%1: '%2' is not valid. No motion started.")
                .arg(m_field.accessibleName(), text.trimmed())
                .toStdString(),
            remedy.toStdString()};
}

} // namespace halbench::app
