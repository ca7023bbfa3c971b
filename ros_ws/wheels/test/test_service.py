"""Laws of `ros2 service`."""

from command_line import output, refusal
import pytest
from small_ros2.command import CommandError
from small_ros2.filling import filled
from std_srvs.srv import SetBool

pytestmark = pytest.mark.usefixtures('talker')


def test_the_list_shows_services_with_their_types() -> None:
    lines = output('service', 'list', '-t').splitlines()
    assert lines == sorted(lines)
    assert '/crowd/mute [std_srvs/srv/SetBool]' in lines


def test_a_call_prints_request_and_response() -> None:
    text = output('service', 'call', '/crowd/mute', 'std_srvs/srv/SetBool', '{data: true}')
    assert text.removeprefix('waiting for service to become available...\n') == (
        'requester: making request: std_srvs.srv.SetBool_Request(data=True)\n\n'
        'response:\n'
        "std_srvs.srv.SetBool_Response(success=True, message='data was True')\n\n"
    )


def test_a_type_that_no_package_has_is_refused() -> None:
    error = refusal('service', 'call', '/crowd/mute', 'std_srvs/srv/Nothing')
    assert error == 'The passed service type is invalid'


@pytest.mark.parametrize('values', ['{dat: true}', '{data: 3}', '{data: [}', '7'])
def test_values_that_do_not_fit_are_refused(values: str) -> None:
    with pytest.raises(CommandError, match='Failed to populate field: '):
        filled(SetBool.Request, values)
