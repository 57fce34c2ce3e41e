// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/interrupt.h>

#include <deal.II/base/mpi.h>

#include <csignal>

namespace Riedel
{
  namespace
  {
    volatile std::sig_atomic_t remembered = 0;



    extern "C" void
    remember(const int signal)
    {
      remembered = 1;
      std::signal(signal, SIG_DFL);
    }
  } // namespace



  Interrupt::Interrupt(const MPI_Comm communicator)
    : communicator(communicator)
  {
    remembered = 0;
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
  }



  Interrupt::~Interrupt()
  {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }



  bool
  Interrupt::requested() const
  {
    const int here = remembered;
    return dealii::Utilities::MPI::max(here, communicator) != 0;
  }
} // namespace Riedel
