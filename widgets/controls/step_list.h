#pragma once

#include <QListWidget>
#include <QString>
#include <QStringList>

namespace halbench::widgets {

enum class StepState { Waiting, Current, Running, Done, Warning, Failed, Skipped };

/// The steps of a wizard at its left: number, name and state, as symbol and in words. A step can be gone to
/// with mouse or keyboard once it is reachable.
class StepList : public QListWidget {
    Q_OBJECT
public:
    explicit StepList(QWidget* parent = nullptr);

    void setSteps(const QStringList& names);
    /// `detail` stands in the tooltip, e.g. why a step failed.
    void setStepState(int step, StepState state, const QString& detail = {});
    StepState stepState(int step) const;
    void setReachable(int step, bool isReachable);
    void setCurrentStep(int step); ///< the page that is shown; does not send stepChosen

    QSize sizeHint() const override;

Q_SIGNALS:
    void stepChosen(int step); ///< by the user

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh(int step);
};

} // namespace halbench::widgets
