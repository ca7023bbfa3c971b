"""The type FollowPath with requests that are read quickly."""

import ctypes
from typing import Any

from rclpy.type_support import check_for_type_support

from socialnav.messages.follow_requests import readable, request_at

CONVERT = ctypes.PYFUNCTYPE(ctypes.py_object, ctypes.c_void_p)
"""A function that makes an object of a message in memory, as rclpy calls it."""
CONVERSION = CONVERT(request_at)
"""It must live as long as requests may come."""


def follow_path_type() -> Any:
    """
    Return an action type for a server, which gets a FollowRequest for the goal.

    rclpy asks the type of a message how one that has come is converted; here that is answered for
    requests, while everything else is that of nav2_msgs.

    :raises ImportError: nav2_msgs is not installed.
    :raises ValueError: its FollowPath is another one than is known here.
    """
    from nav2_msgs.action import FollowPath

    fields = FollowPath.Goal.get_fields_and_field_types()
    if not readable(fields):
        raise ValueError(f'nav2_msgs/action/FollowPath is not known in this form: {fields}')
    check_for_type_support(FollowPath)
    services = vars(FollowPath.Impl)
    request = light(FollowPath.Impl.SendGoalService.Request)
    response = FollowPath.Impl.SendGoalService.Response
    service = type('SendGoalService', (), {'Request': request, 'Response': response})
    public = {name: value for name, value in services.items() if not name.startswith('_')}
    parts = {
        'Impl': type('Impl', (), public | {'SendGoalService': service}),
        'Result': FollowPath.Result, 'Feedback': FollowPath.Feedback,
    }  # fmt: skip
    support = type('Support', (type,), {'_TYPE_SUPPORT': type(FollowPath)._TYPE_SUPPORT})
    return support('FollowPath', (), parts)


def light(request: Any) -> type:
    """Return the type of a request that is not converted as usual but by request_at."""
    names = ('_CREATE_ROS_MESSAGE', '_DESTROY_ROS_MESSAGE', '_CONVERT_FROM_PY', '_TYPE_SUPPORT')
    usual = {name: getattr(type(request), name) for name in names}
    conversion = capsule(CONVERSION)
    metaclass = type('LightMeta', (type,), usual | {'_CONVERT_TO_PY': conversion})
    return metaclass('LightRequest', (), {})


def capsule(function: Any) -> object:
    """Return a pointer to a function as C code hands it through Python."""
    new = ctypes.pythonapi.PyCapsule_New
    new.restype = ctypes.py_object
    new.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
    return new(ctypes.cast(function, ctypes.c_void_p), None, None)
