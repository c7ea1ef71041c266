// What the fields of the filter editor are called.
#include "app/workspaces/tune/loop/filter_editor.h"
#include "widgets/controls/optional_number_edit.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <utility>

namespace halbench::app {

void FilterEditor::sayFilter(std::size_t at) {
    const Filter& row = m_rows[at];
    const QString kinds[] = {tr("Lead"), tr("Lag"), tr("Notch"), tr("Low-pass"), tr("Section")};
    for (int i = 0; i < row.kind->count(); ++i) {
        row.kind->setItemText(i, kinds[i]);
    }
    const QString frequency = m_unit == FrequencyUnit::Hertz ? QStringLiteral("Hz") : QStringLiteral("rad/s");
    struct Figure {
        QString name;
        QString unit;
        QString help;
    };
    const std::vector<Figure> figures[] = {
        {{tr("Frequency"), frequency, tr("Frequency of the added phase; the gain there is unchanged")},
         {tr("Phase"), QStringLiteral("\u00b0"), tr("Phase added at this frequency")}},
        {{tr("Frequency"), frequency, tr("Gain is unchanged far above this frequency")},
         {tr("DC gain"), QStringLiteral("\u00d7"), tr("Factor on the DC gain, above 1")}},
        {{tr("Frequency"), frequency, tr("Frequency of minimum gain")},
         {tr("Depth"), QStringLiteral("\u00d7"), tr("Gain factor at this frequency, 0 to 1")},
         {tr("Damping"), {}, tr("Damping of the poles: larger is wider")}},
        {{tr("Corner"), frequency, tr("Frequency of −3 dB")}, {tr("Order"), {}, tr("1 or 2")}},
        {{QStringLiteral("b0"), {}, tr("Coefficient of (b0 d² + b1 d + b2)/(d² + a1 d + a2), d = z − 1")},
         {QStringLiteral("b1"), {}, tr("Coefficient of d in the numerator")},
         {QStringLiteral("b2"), {}, tr("Coefficient of 1 in the numerator")},
         {QStringLiteral("a1"), {}, tr("Coefficient of d in the denominator; 0: no dynamics")},
         {QStringLiteral("a2"), {}, tr("Coefficient of 1 in the denominator")}}};
    const QString name = tr("Filter %1").arg(at + 1);
    row.kind->setAccessibleName(tr("%1: kind").arg(name));
    row.kind->setToolTip(
        tr("Lead: adds phase at a frequency. Lag: raises the DC gain. Notch: lowers the gain at a frequency. "
           "Low-pass: lowers the gain above a frequency. Section: second order by coefficients"));
    row.remove->setAccessibleName(tr("Remove %1").arg(name));
    row.remove->setToolTip(row.remove->accessibleName());
    for (std::size_t i = 0; i < row.fields.size(); ++i) {
        const auto& [figure, unit, help] = figures[row.filter.index()][i];
        row.fields[i].name->setText(figure);
        row.fields[i].unit->setText(unit);
        row.fields[i].edit->setAccessibleName(QStringLiteral("%1: %2").arg(name, figure));
        row.fields[i].edit->setExplanation(help);
        row.fields[i].edit->setObjectName(QStringLiteral("filter%1.%2").arg(at + 1).arg(i));
    }
}

void FilterEditor::sayWords() {
    m_toggle->setText(tr("Weights and filters"));
    m_toggle->setToolTip(tr("Set-point weights, derivative filter and series filters"));
    m_toggle->setAccessibleName(m_toggle->text());
    sayOffered();
    m_add->setText(tr("Add a filter"));
    m_add->setToolTip(tr("In series with the others, four at most; low-pass first"));
    m_add->setAccessibleName(m_add->text());
    const std::pair<Field*, std::pair<QString, QString>> fields[] = {
        {&m_b, {tr("Set-point weight b (P)"), tr("Weight on K_P: below 1 gives a softer set-point step")}},
        {&m_c,
         {tr("Set-point weight c (D)"), tr("Weight on K_D: 0 ignores a set-point step, 1 passes all of it")}},
        {&m_time, {tr("Derivative filter time"), tr("Time constant; 0: difference of two samples")}}};
    for (const auto& [field, words] : fields) {
        field->name->setText(words.first);
        field->edit->setAccessibleName(words.first);
        field->edit->setExplanation(words.second);
    }
    m_time.unit->setText(QStringLiteral("s"));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        sayFilter(i);
    }
}

/// A device that lacks one of them refuses laws that need it: which, is said where gains are applied.
void FilterEditor::sayOffered() {
    if (!m_offered) {
        m_note->setText(tr("For analysis and C export. A connected device may run them as well."));
        return;
    }
    const bool hasWeights = m_offered->hasReferenceWeight && m_offered->hasDerivativeReferenceWeight &&
                            m_offered->hasDerivativeFilter;
    const auto filters = static_cast<int>(m_offered->filters);
    m_note->setText(
        hasWeights && filters > 0 ? tr("This device runs them, with up to %1 filters.").arg(filters)
        : hasWeights || filters > 0
            ? tr("This device runs a part of them; the others are for analysis and C export only.")
            : tr("This device does not run them: for analysis and C export only."));
}

void FilterEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        sayWords();
    }
}

} // namespace halbench::app
