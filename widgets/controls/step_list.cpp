#include "widgets/controls/step_list.h"

#include "widgets/theme/icons.h"

#include <QEvent>
#include <QSignalBlocker>

namespace halbench::widgets {
namespace {

enum ItemRole { StateRole = Qt::UserRole, NameRole, DetailRole };

struct Look {
    QString icon;
    Role role;
    QString words;
};

Look lookOf(StepState state) {
    switch (state) {
    case StepState::Current:
        return {QStringLiteral("current"), Role::Primary, StepList::tr("current")};
    case StepState::Running:
        return {QStringLiteral("play"), Role::Armed, StepList::tr("running")};
    case StepState::Done:
        return {QStringLiteral("ok"), Role::Good, StepList::tr("done")};
    case StepState::Warning:
        return {QStringLiteral("warning"), Role::Warn, StepList::tr("done with a warning")};
    case StepState::Failed:
        return {QStringLiteral("error"), Role::Bad, StepList::tr("failed")};
    case StepState::Skipped:
        return {QStringLiteral("skipped"), Role::Muted, StepList::tr("skipped")};
    case StepState::Waiting:
        break;
    }
    return {QStringLiteral("waiting"), Role::Muted, StepList::tr("waiting")};
}

} // namespace

StepList::StepList(QWidget* parent) : QListWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSpacing(1);
    setProperty("surface", QStringLiteral("steps")); // it tells, it is no field
    setIconSize({16, 16});
    setAccessibleName(tr("Steps"));
    connect(this, &QListWidget::currentRowChanged, this, &StepList::stepChosen);
}

void StepList::setSteps(const QStringList& names) {
    const QSignalBlocker blocker(this);
    clear();
    for (const QString& name : names) {
        auto* entry = new QListWidgetItem(this);
        entry->setData(NameRole, name);
        entry->setData(StateRole, static_cast<int>(StepState::Waiting));
        refresh(count() - 1);
    }
    updateGeometry();
}

void StepList::setStepState(int step, StepState state, const QString& detail) {
    item(step)->setData(StateRole, static_cast<int>(state));
    item(step)->setData(DetailRole, detail);
    refresh(step);
}

StepState StepList::stepState(int step) const {
    return static_cast<StepState>(item(step)->data(StateRole).toInt());
}

void StepList::setReachable(int step, bool isReachable) {
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    item(step)->setFlags(isReachable ? flags : Qt::NoItemFlags);
}

void StepList::setCurrentStep(int step) {
    const QSignalBlocker blocker(this);
    setCurrentRow(step);
}

QSize StepList::sizeHint() const {
    const int words = qMax(sizeHintForColumn(0), 30 * GridStep_px);
    return {words + 6 * GridStep_px, QListWidget::sizeHint().height()};
}

void StepList::refresh(int step) {
    QListWidgetItem* entry = item(step);
    const Look look = lookOf(stepState(step));
    const QString name = tr("%1. %2").arg(step + 1).arg(entry->data(NameRole).toString());
    const QString detail = entry->data(DetailRole).toString();
    entry->setText(name);
    entry->setIcon(themedIcon(look.icon, look.role));
    entry->setToolTip(detail.isEmpty() ? tr("%1: %2").arg(name, look.words)
                                       : tr("%1: %2. %3").arg(name, look.words, detail));
    entry->setData(Qt::AccessibleTextRole, tr("Step %1 of %2, %3, %4")
                                               .arg(step + 1)
                                               .arg(count())
                                               .arg(entry->data(NameRole).toString(), look.words));
}

void StepList::changeEvent(QEvent* event) {
    QListWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        for (int step = 0; step < count(); ++step) {
            refresh(step);
        }
    }
}

} // namespace halbench::widgets
