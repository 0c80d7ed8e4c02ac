// Sends a drill's state to a rig's [[udp]]. In Unity: put it on a game object; elsewhere call Send() at a steady pace,
// 20 to 60 times a second: silence makes signals stale.
using System.Globalization;
using System.Net.Sockets;
using System.Text;
using UnityEngine;

public class UdpSender : MonoBehaviour
{
    public string host = "127.0.0.1";
    public int port = 1503;
    public float engineRpm = 800;
    public float feedPressureBar;
    public bool percussion;
    public string rattling = "none";  // "none", "closed", "open"
    public int rodCount = 1;

    private UdpClient client;
    private long sequence;

    private void OnEnable() => client = new UdpClient(host, port);
    private void OnDisable() => client.Dispose();
    private void FixedUpdate() => Send();

    private void Send()
    {
        // Numbers with a decimal point, whatever the machine's language.
        string text = string.Format(CultureInfo.InvariantCulture,
            "{{\"engine_rpm\":{0},\"feed_pressure_bar\":{1},\"percussion\":{2},\"rattling\":\"{3}\",\"rod_count\":{4},\"seq\":{5}}}",
            engineRpm, feedPressureBar, percussion ? "true" : "false", rattling, rodCount, sequence++);
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        client.Send(bytes, bytes.Length);
    }
}
