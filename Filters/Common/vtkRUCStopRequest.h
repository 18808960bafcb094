// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCStopRequest
 * @brief The wish of a user that the running search end with its best so far
 *
 * A client makes the wish by a client-server stream to the root of the data server that calls
 * `Make` with `Token`. Without a server that happens at once, in the middle of the run. A server
 * reads its messages only after the run, but the message lies in the socket by then. Hence
 * `IsPending` looks for the token in what has come in, without taking it out. The wish thus needs
 * no connection of its own, no file and no reading of messages out of turn, and reaches the server
 * through whatever tunnel the session itself goes. When the server reads the message later, it has
 * no effect, as every run begins with `Clear`.
 *
 * ParaView 5.11 has no way of its own: its abort button is disabled for filters, and a property
 * that the client sets arrives after the run.
 */
#ifndef vtkRUCStopRequest_h
#define vtkRUCStopRequest_h

#include "RUCCommonModule.h"

#include "vtkObject.h"

class RUCCOMMON_EXPORT vtkRUCStopRequest : public vtkObject
{
public:
  static vtkRUCStopRequest* New();
  vtkTypeMacro(vtkRUCStopRequest, vtkObject);

  /** The text that a message with the wish holds, and no other message. */
  static const char* Token();

  /** Wishes that the run of this process end; does nothing unless `token` is the token. */
  void Make(const char* token);

  /** Forgets the wish. It is called at the start of a run. */
  static void Clear();

  /**
   * Returns whether there is a wish. It is asked on the first rank, and takes a microsecond or two.
   */
  static bool IsPending();

protected:
  vtkRUCStopRequest() = default;
  ~vtkRUCStopRequest() override = default;

private:
  vtkRUCStopRequest(const vtkRUCStopRequest&) = delete;
  void operator=(const vtkRUCStopRequest&) = delete;
};

#endif
