// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause

// Its signals are caught as Open CASCADE itself is built for.
#ifndef OCC_CONVERT_SIGNALS
#define OCC_CONVERT_SIGNALS
#endif

#include "CADSession.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <OSD.hxx>
#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <array>
#include <csignal>
#include <exception>
#include <mutex>
#include <new>

namespace sbvtk
{
namespace
{

std::mutex oneSession;

/** Open CASCADE's messages go nowhere while this lives. */
class Silence
{
public:
  Silence()
    : Printers(Message::DefaultMessenger()->Printers())
  {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~Silence() { Message::DefaultMessenger()->ChangePrinters() = this->Printers; }
  Silence(const Silence&) = delete;
  void operator=(const Silence&) = delete;

private:
  Message_SequenceOfPrinters Printers;
};

/** Signals of the processor become exceptions while this lives; the host's handlers are put back.
 */
class Signals
{
public:
  Signals()
  {
    for (std::size_t i = 0; i < this->Numbers.size(); ++i)
    {
      sigaction(this->Numbers[i], nullptr, &this->Before[i]);
    }
    OSD::SetSignal(Standard_False);
    for (std::size_t i = 0; i < usersSignals; ++i)
    {
      sigaction(this->Numbers[i], &this->Before[i], nullptr);
    }
  }
  ~Signals()
  {
    for (std::size_t i = 0; i < this->Numbers.size(); ++i)
    {
      sigaction(this->Numbers[i], &this->Before[i], nullptr);
    }
  }
  Signals(const Signals&) = delete;
  void operator=(const Signals&) = delete;

private:
  static constexpr std::size_t usersSignals = 3; // the first ones remain the host's business
  std::array<int, 8> Numbers{ SIGHUP, SIGINT, SIGQUIT, SIGILL, SIGFPE, SIGBUS, SIGSEGV, SIGSYS };
  std::array<struct sigaction, 8> Before{};
};

/** Its progress as ours. */
class Indicator : public Message_ProgressIndicator
{
public:
  Indicator(sb::Monitor& monitor, double first, double last, const char* stage)
    : Host(monitor)
    , First(first)
    , Last(last)
    , Stage(stage)
  {
  }

protected:
  Standard_Boolean UserBreak() override { return this->Host.Aborted(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override
  {
    constexpr double step = 0.01;
    if (this->GetPosition() >= this->Shown + step)
    {
      this->Shown = this->GetPosition();
      this->Host.Progress(this->First + this->Shown * (this->Last - this->First), this->Stage);
    }
  }

private:
  sb::Monitor& Host;
  double First;
  double Last;
  const char* Stage;
  double Shown = 0.0;
};

std::string Words(const Standard_Failure& failure)
{
  const char* message = failure.GetMessageString();
  return message && *message ? message : failure.DynamicType()->Name();
}

} // namespace

CADOutcome RunCAD(sb::Monitor& monitor, double first, double last, const char* stage,
  const std::function<void(const Message_ProgressRange&)>& work)
{
  const std::lock_guard<std::mutex> lock(oneSession);
  const Silence silence;
  const Signals signals;
  monitor.Progress(first, stage);
  const Handle(Indicator) indicator = new Indicator(monitor, first, last, stage);
  CADOutcome outcome;
  try
  {
    OCC_CATCH_SIGNALS
    work(indicator->Start());
  }
  catch (const Standard_OutOfMemory&)
  {
    outcome.Status = CADStatus::OutOfMemory;
  }
  catch (const Standard_Failure& failure)
  {
    outcome = { CADStatus::Failed, Words(failure) };
  }
  catch (const std::bad_alloc&)
  {
    outcome.Status = CADStatus::OutOfMemory;
  }
  catch (const std::exception& failure)
  {
    outcome = { CADStatus::Failed, failure.what() };
  }
  if (monitor.Aborted())
  {
    outcome.Status = CADStatus::Aborted;
  }
  return outcome;
}

} // namespace sbvtk
