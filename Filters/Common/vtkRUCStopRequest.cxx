// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCStopRequest.h"

#include "vtkClientSocket.h"
#include "vtkCompositeMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkSocketCommunicator.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include <sys/socket.h>

vtkStandardNewMacro(vtkRUCStopRequest);

namespace
{
bool IsWished = false;

// The socket to the client that waits for this server, or -1 where there is none
int ClientSocket()
{
  vtkProcessModule* module = vtkProcessModule::GetProcessModule();
  auto* session = module ? vtkPVSession::SafeDownCast(module->GetSession()) : nullptr;
  vtkMultiProcessController* controller =
    session ? session->GetController(vtkPVSession::CLIENT) : nullptr;
  if (auto* clients = vtkCompositeMultiProcessController::SafeDownCast(controller))
  {
    controller = clients->GetActiveController();
  }
  auto* communicator =
    controller ? vtkSocketCommunicator::SafeDownCast(controller->GetCommunicator()) : nullptr;
  vtkClientSocket* socket = communicator ? communicator->GetSocket() : nullptr;
  return socket ? socket->GetSocketDescriptor() : -1;
}
}

const char* vtkRUCStopRequest::Token()
{
  return "representative unit cell: stop 5f0c8e2ad94b71c3";
}

void vtkRUCStopRequest::Make(const char* token)
{
  IsWished = IsWished || (token && std::strcmp(token, Token()) == 0);
}

void vtkRUCStopRequest::Clear()
{
  IsWished = false;
}

bool vtkRUCStopRequest::IsPending()
{
  const int socket = IsWished ? -1 : ClientSocket();
  if (socket >= 0)
  {
    // Little can lie before the wish: the client waits for the run, and most of what it sends needs
    // an answer.
    std::vector<char> waiting(1 << 16);
    const ssize_t size =
      recv(socket, waiting.data(), waiting.size(), MSG_PEEK | MSG_DONTWAIT); // -1 for nothing
    const char* token = Token();
    const auto end = waiting.begin() + std::max<ssize_t>(size, 0);
    IsWished = std::search(waiting.begin(), end, token, token + std::strlen(token)) != end;
  }
  return IsWished;
}
